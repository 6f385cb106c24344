import { traitsFor } from '#my-robot/my-robot';
import { filesByName } from '#project/project';
import { hardwareIds } from '#simulation/hardware';
import type { InputEvent } from '#simulation/input';
import { soloRun, type RunSetup } from '#simulation/run-setup';

import { fittingInputs } from '../run/fitting-inputs';
import { hardwareNow } from './hardware/use-hardware';
import { seedOf } from './hardware/hardware';
import { boardWish } from './settings/devices';
import type { WorkParts } from './model/parts';

/**
 * The set-up of a run that starts now: the present work on the chosen device. What the hand has moved is back at its
 * place.
 *
 * @param sensed what was set on the sensors and holds from the start
 */
export function runSetup(parts: WorkParts, sensed: readonly InputEvent[]): RunSetup {
  const { work, settings } = parts;
  const hardware = hardwareNow(parts);
  const { device, robot, reality, myRobot } = settings.current.value;
  const traits = traitsFor(myRobot, hardware?.robot?.id);
  const inputs = hardware === null ? [] : fittingInputs(sensed, hardware.board);
  if (hardware !== null && hardware.robot !== null && settings.current.value.arenaSenses)
    inputs.push({ timeUs: 0, action: { type: 'arena-senses', on: true } });
  return soloRun({
    scene: work.scene.value,
    files: filesByName(work.files.value),
    ...(hardware === null ? { robot, board: boardWish(device) } : hardwareIds(hardware)),
    repl: 'at-once',
    seed: seedOf(settings.current.value),
    robotOptions: hardware?.options ?? {},
    reality,
    ...(traits === undefined ? {} : { traits }),
    inputs,
  });
}
