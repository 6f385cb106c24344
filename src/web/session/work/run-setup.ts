import { traitsFor } from '#my-robot/traits-for';
import { filesByName } from '#project/project';
import { feelingInputs } from '#simulation/feeling';
import { hardwareIds } from '#simulation/hardware';
import type { InputEvent } from '#simulation/input';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';

import { fittingInputs } from '../run/fitting-inputs';
import { hardwareNow } from './hardware/use-hardware';
import { deviceAt } from './hardware/device-at';
import { seedOf } from './hardware/hardware';
import { boardWish } from './settings/devices';
import type { WorkParts } from './model/parts';

/**
 * The set-up of a run that starts now: the present work on the chosen devices. What the hand has moved is back at its
 * place.
 *
 * @param sensed inputs that set the sensors of the device at a place from the start
 */
export function runSetup(parts: WorkParts, sensed: (place: number) => readonly InputEvent[]): RunSetup {
  const { work, settings } = parts;
  const names = work.devices.value;
  const [first, ...others] = names.map((name, place) => deviceSetup(parts, name, place));
  if (first === undefined) throw new RangeError('A project has at least one device.');
  const devices = [first, ...others] as const;
  const byHand = names.flatMap((name, place) =>
    handInputs(parts, place, sensed(place)).map((event) => (place === 0 ? event : { ...event, device: name })),
  );
  return {
    scene: work.scene.value,
    devices,
    repl: 'at-once',
    seed: seedOf(settings.current.value),
    reality: settings.current.value.reality,
    inputs: settings.current.value.arenaSenses ? [...feelingInputs(devices), ...byHand] : byHand,
  };
}

function deviceSetup(parts: WorkParts, name: string, place: number): DeviceSetup {
  const { project, settings } = deviceAt(parts, place);
  const hardware = hardwareNow(parts, place);
  const traits = traitsFor(settings.myRobot, hardware?.robot?.id);
  return {
    name,
    files: filesByName(project.files),
    ...(hardware === null ? { robot: settings.robot, board: boardWish(settings.device) } : hardwareIds(hardware)),
    robotOptions: hardware?.options ?? {},
    ...(traits === undefined ? {} : { traits }),
  };
}

/** The inputs for a device that the hand has set, as far as its board has them. */
function handInputs(parts: WorkParts, place: number, sensed: readonly InputEvent[]): readonly InputEvent[] {
  const hardware = hardwareNow(parts, place);
  return hardware === null ? [] : fittingInputs(sensed, hardware.board);
}
