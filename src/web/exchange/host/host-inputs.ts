import type { Refusal } from '#embed/simulator';
import { movableIds } from '#simulation/at-once';
import { reachesAll, type InputAction } from '#simulation/input';
import { placeOfDevice } from '#simulation/several/place-of-device';
import { checkFor, createInputCheck } from '#simulation/run-problem';

import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import { hardwareNow } from '../../session/work/hardware/use-hardware';

/** A host's actions on the run, separate from a user's actions on the page: they need no echo. */
export interface HostInputs {
  /** @param device its name; left out: the first, or all that it reaches */
  take(action: InputAction, device?: string): Refusal;
  /** True while an action of the host is being done to the run. */
  isOwn(): boolean;
}

/** Takes a host's actions on the run of this app. Without a run it refuses what the run itself would refuse. */
export function hostInputs(parts: Pick<RunParts, 'run' | 'sensors'> & WorkParts): HostInputs {
  const { run, work, sensors } = parts;
  let isOwn = false;
  const act = (action: InputAction, place: number | undefined): boolean => {
    isOwn = true;
    try {
      return action.type === 'sensor' && typeof action.value === 'number'
        ? sensors.set(action.id, action.value, place ?? 0)
        : run.input(action, place);
    } finally {
      isOwn = false;
    }
  };
  return {
    isOwn: () => isOwn,
    take(action, device) {
      const names = work.devices.value;
      const place = placeOfDevice(names, device);
      if (typeof place === 'string') return place;
      const scene = work.scene.value;
      const checks = names.flatMap((_, at) => {
        const hardware = hardwareNow(parts, at);
        return hardware === null ? [] : [createInputCheck(hardware, scene)];
      });
      if (checks.length < names.length) return 'The course names a board or a robot that this app does not have.';
      const check = checkFor({ names, checks }, device);
      const problem = typeof check === 'string' ? check : check(action, scene, movableIds(new Set(), scene, scene));
      if (problem !== null) return problem;
      const isTaken = act(action, device === undefined && reachesAll(action) ? undefined : place);
      return isTaken ? null : 'The task that is open is done without the hand.';
    },
  };
}
