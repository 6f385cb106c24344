import { watch } from 'vue';

import type { Refusal } from '#embed/simulator';
import type { Scene } from '#scene/scene';
import { movableIds } from '#simulation/at-once';
import type { Hardware } from '#simulation/hardware';
import type { InputAction } from '#simulation/input';
import { createInputCheck } from '#simulation/run-problem';

import { slownessOf } from '../board/drawing/board-press';
import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';
import type { VisitParts } from '../visit/parts';
import { hardwareOf } from '../work/hardware/hardware';
import { pressOf } from '../run/worker/first-presses';
import { SpacedPresses } from './spaced-presses';

/** A running run that has sent no picture for this long is not being drawn, in ms at full speed. Chosen: many frames. */
const BLIND_MS = 300;

/** A host's actions on the run, separate from a user's actions on the page: they need no echo. */
export interface HostInputs {
  take(action: InputAction): Refusal;
  /** Whether what is done to the run at this moment is the host's. */
  isOwn(): boolean;
}

/** Takes what a host does to the run of this app. Buttons and pads stay down as long as the board needs to notice. */
export function hostInputs(app: Pick<RunParts, 'run' | 'sensors'> & WorkParts & VisitParts): HostInputs {
  let isOwn = false;
  const act = (action: InputAction): void => {
    isOwn = true;
    try {
      if (action.type === 'sensor' && typeof action.value === 'number') app.sensors.set(action.id, action.value);
      else app.run.input(action);
    } finally {
      isOwn = false;
    }
  };
  const presses = followRun(app);
  return {
    isOwn: () => isOwn,
    take(action) {
      const hardware = hardwareOf(app.work.work.value.project, app.settings.current.value);
      if (hardware === null) return 'The course names a board or a robot that this app does not have.';
      const problem = inputProblem(action, hardware, app.work.scene.value);
      if (problem !== null) return problem;
      const press = app.run.isActive.value ? pressOf(action) : null;
      if (press === null) act(action);
      else presses.set(press.id, press.down, () => act(action));
      return null;
    },
  };
}

/** The presses of the current run; they continue with its time. */
function followRun({
  run,
  settings,
  host,
}: Pick<RunParts, 'run'> & Pick<WorkParts, 'settings'> & VisitParts): Pick<SpacedPresses, 'set'> {
  const presses = new SpacedPresses();
  let timer: ReturnType<typeof setTimeout> | undefined;
  const wait = (): void => {
    clearTimeout(timer);
    if (!presses.isWaiting || run.phase.value !== 'running') return;
    timer = setTimeout(
      () => {
        presses.advanceBlindly();
        wait();
      },
      BLIND_MS * slownessOf(settings.current.value.speed),
    );
  };
  const atOnce = { flush: 'sync' } as const;
  watch(
    run.snapshot,
    (snapshot) => {
      if (snapshot === null) return;
      presses.advance(snapshot.timeUs);
      wait();
    },
    atOnce,
  );
  watch(
    run.phase,
    () => {
      if (!run.isActive.value) presses.settle();
      wait();
    },
    atOnce,
  );
  host.listen(({ type }) => {
    if (type === 'started') presses.settle();
  });
  return {
    set(id, down, tell) {
      presses.set(id, down, tell);
      wait();
    },
  };
}

/** What the run itself would say: a page without a run refuses the same. */
function inputProblem(action: InputAction, { board, robot }: Hardware, scene: Scene): Refusal {
  const check = createInputCheck(board, scene, robot !== null);
  return check(action, scene, movableIds(new Set(), scene, scene));
}
