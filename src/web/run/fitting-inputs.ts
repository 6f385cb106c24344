import type { BoardType } from '#board/boards/board-type';
import type { InputEvent } from '#simulation/input';

/**
 * What was set by hand or by a host and holds for every run, without touch pads that this board lacks: a run would
 * refuse to start with them.
 */
export function fittingInputs(inputs: readonly InputEvent[], { pins }: BoardType): InputEvent[] {
  const pads = pins.flatMap(({ name, touch }) => (touch === null ? [] : [name.replace('_logo', 'Logo')]));
  return inputs.filter(
    ({ action }) => action.type !== 'sensor' || !action.id.startsWith('pin') || pads.includes(action.id),
  );
}
