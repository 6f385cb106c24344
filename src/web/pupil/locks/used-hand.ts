import { watch } from 'vue';

import { draftOf } from '#check/task/read-task';
import { plainWorld, type WorldVariant } from '#check/task/task';
import type { InputAction } from '#simulation/input';

import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';

/**
 * Notes whether the last run was helped by hand: things moved, or something pressed or set that the task does not give.
 */
export class UsedHand {
  isUsed = false;

  constructor(private readonly app: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>) {
    const { run, work } = app;
    watch(
      run.recording,
      ({ setup }) => {
        if (setup !== null) this.isUsed = (setup.inputs ?? []).some(({ action }) => this.counts(action));
      },
      { immediate: true, flush: 'sync' },
    );
    watch(work.openings, () => (this.isUsed = false), { flush: 'sync' });
  }

  /** Notes an action on the run, if there is one. */
  does(action: InputAction): void {
    if (this.app.run.isActive.value) this.isUsed ||= this.counts(action);
  }

  private counts(action: InputAction): boolean {
    const what = nameOf(action);
    if (what === null || (action.type === 'serial' && this.app.run.hasEnded.value)) return false;
    const read = draftOf(this.app.work.work.value.project);
    return !givenIn('task' in read ? read.task.worlds[0] : plainWorld).includes(what);
  }
}

/** The events that a world brings itself. */
const givenIn = ({ sensors, inputs }: WorldVariant): readonly (string | null)[] => [
  ...Object.keys(sensors).map((id) => `sensor ${id}`),
  ...inputs.map(({ action }) => nameOf(action)),
];

/** The kind of a manual action, without its amount; `null`: no manual action, or one that the program cannot notice. */
function nameOf(action: InputAction): string | null {
  switch (action.type) {
    case 'button':
      return `button ${action.button}`;
    case 'touch':
      return `touch ${action.pad}`;
    case 'sensor':
      return `sensor ${action.id}`;
    case 'remote':
    case 'gamepad':
      return `${action.type} ${action.key}`;
    case 'place-block':
      return `block ${action.id}`;
    case 'switch':
      return `switch ${action.id}`;
    case 'place':
    case 'serial':
    case 'stick':
    case 'radio':
      return action.type;
    default:
      return null;
  }
}
