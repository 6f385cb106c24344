import { steady } from '../../kit/steady';
import type { RunParts } from '../../session/run/parts';
import { pressBoard } from './drawing/board-press';
import { usePresses } from './drawing/use-presses';

/** The display and the two buttons of a board without its drawing. */
export function useSmallBoard({ run }: Pick<RunParts, 'run'>) {
  const presses = usePresses({
    press: (key) => pressBoard(run, key, true),
    release: (key) => pressBoard(run, key, false),
  });
  const dark = Array.from({ length: 25 }, () => 0);
  const held = steady(() => ({ a: false, b: false, ...run.shown.value?.buttons }));
  return {
    levels: steady(() => run.shown.value?.display ?? dark),
    isDown: (key: 'a' | 'b'): boolean => presses.down.value.has(key) || held.value[key],
    buttons: [
      { key: 'a', letter: 'A', label: 'board.pressA', on: presses.handlersFor(['a']) },
      { key: 'b', letter: 'B', label: 'board.pressB', on: presses.handlersFor(['b']) },
    ] as const,
  };
}
