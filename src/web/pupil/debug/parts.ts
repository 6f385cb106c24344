import { lateParts } from '../../kit/part';
import { usePage } from '../../kit/parts';
import type { WithLate } from '../../kit/state/late-models';
import { useRun, type RunParts } from '../../session/run/parts';
import { useWork, type WorkParts } from '../../session/work/model/parts';
import { DebugSlot } from './debug-slot';

/** Break points, stops and variables of programs. */
export interface DebugParts {
  readonly slot: DebugSlot;
}

export const [debugOf, useDebug] = lateParts(
  () => ({ ...usePage(), ...useRun(), ...useWork() }),
  ({ run, work }: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'> & WithLate): DebugParts => ({
    slot: new DebugSlot({ run, work, engine: run.engine }),
  }),
);
