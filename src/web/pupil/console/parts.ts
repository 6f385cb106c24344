import { ConsoleModel } from './console-model';
import { createJump, type Jump } from './jump';
import { lateParts } from '../../kit/part';
import { usePage } from '../../kit/parts';
import { robotInErrorNow } from '../../session/work/hardware/use-hardware';
import { useWork, type WorkParts } from '../../session/work/model/parts';
import type { WithLate } from '../../kit/state/late-models';

/** The console, and the way from its errors to the line. */
export interface ConsoleParts {
  readonly console: ConsoleModel;
  readonly jump: Jump;
}

export const [consoleOf, useConsole] = lateParts(
  () => ({ ...usePage(), ...useWork() }),
  ({ work, settings }: WorkParts & WithLate): ConsoleParts => ({
    console: new ConsoleModel(
      (device) => robotInErrorNow({ work, settings }, device),
      () => work.place.value,
    ),
    jump: createJump(work),
  }),
);
