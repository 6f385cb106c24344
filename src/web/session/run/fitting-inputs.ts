import type { BoardType } from '#board/boards/board-type';
import type { InputEvent } from '#simulation/input';

/**
 * The inputs set by hand or by a host for every run, without touch pads that this board lacks: with them a run would
 * refuse to start.
 */
export function fittingInputs(inputs: readonly InputEvent[], { pins }: BoardType): InputEvent[] {
  const pads = pins.flatMap(({ name, touch }) => (touch === null ? [] : [name.replace('_logo', 'Logo')]));
  return inputs.filter(
    ({ action }) => action.type !== 'sensor' || !action.id.startsWith('pin') || pads.includes(action.id),
  );
}
