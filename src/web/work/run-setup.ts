import { filesByName } from '#project/project';
import { hardwareIds } from '#simulation/hardware';
import type { InputEvent } from '#simulation/input';
import type { RunSetup } from '#simulation/run-setup';

import { fittingInputs } from '../run/fitting-inputs';
import type { RunParts } from '../run/parts';
import { hardwareNow } from './hardware/use-hardware';
import { seedOf } from './hardware/hardware';
import { boardWish } from './settings/devices';
import type { WorkParts } from './model/parts';

/**
 * The set-up of a run that starts now: the present work on the chosen device, with what the hand has placed.
 *
 * @param sensed what was set on the sensors and holds from the start
 */
export function runSetup(parts: WorkParts & Pick<RunParts, 'hand'>, sensed: readonly InputEvent[]): RunSetup {
  const { work, settings } = parts;
  const hardware = hardwareNow(parts);
  const { device, robot, reality } = settings.current.value;
  const inputs = hardware === null ? [] : fittingInputs(sensed, hardware.board);
  if (hardware !== null && hardware.robot !== null) inputs.push(...robotInputs(parts));
  return {
    scene: work.scene.value,
    files: filesByName(work.files.value),
    ...(hardware === null ? { robot, board: boardWish(device) } : hardwareIds(hardware)),
    repl: 'at-once',
    seed: seedOf(settings.current.value),
    robotOptions: hardware?.options ?? {},
    reality,
    inputs: [...inputs, ...blockInputs(parts)],
  };
}

/** Where the hand has put the robot, and whether its board feels the arena. */
function robotInputs({ settings, hand }: Pick<WorkParts, 'settings'> & Pick<RunParts, 'hand'>): InputEvent[] {
  const placed = hand.pose.value;
  const inputs: InputEvent[] = placed === null ? [] : [{ timeUs: 0, action: { type: 'place', pose: placed } }];
  if (settings.current.value.arenaSenses) inputs.push({ timeUs: 0, action: { type: 'arena-senses', on: true } });
  return inputs;
}

/** Where the hand has put the blocks that are still blocks. */
function blockInputs({ work, hand }: Pick<WorkParts, 'work'> & Pick<RunParts, 'hand'>): InputEvent[] {
  const pushable = new Set(work.scene.value.objects.filter(({ type }) => type === 'block').map(({ id }) => id));
  return Object.entries(hand.blocks.value).flatMap(([id, pose]): InputEvent[] =>
    pushable.has(id) ? [{ timeUs: 0, action: { type: 'place-block', id, pose } }] : [],
  );
}
