import type { Refusal } from '#embed/simulator';
import { movableIds } from '#simulation/at-once';
import type { InputAction } from '#simulation/input';
import { createInputCheck } from '#simulation/run-problem';

import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';
import { hardwareOf } from '../work/hardware/hardware';

/** A host's actions on the run, separate from a user's actions on the page: they need no echo. */
export interface HostInputs {
  take(action: InputAction): Refusal;
  /** Whether what is done to the run at this moment is the host's. */
  isOwn(): boolean;
}

/** Takes what a host does to the run of this app. A page without a run refuses what the run itself would. */
export function hostInputs(parts: Pick<RunParts, 'run' | 'sensors'> & WorkParts): HostInputs {
  const { run, work, settings, sensors } = parts;
  let isOwn = false;
  const act = (action: InputAction): void => {
    isOwn = true;
    try {
      if (action.type === 'sensor' && typeof action.value === 'number') sensors.set(action.id, action.value, 0);
      else run.input(action, 0);
    } finally {
      isOwn = false;
    }
  };
  return {
    isOwn: () => isOwn,
    take(action) {
      const hardware = hardwareOf(work.work.value.project, settings.current.value);
      if (hardware === null) return 'The course names a board or a robot that this app does not have.';
      const scene = work.scene.value;
      const check = createInputCheck(hardware.board, scene, hardware.robot !== null);
      const problem = check(action, scene, movableIds(new Set(), scene, scene));
      if (problem === null) act(action);
      return problem;
    },
  };
}
