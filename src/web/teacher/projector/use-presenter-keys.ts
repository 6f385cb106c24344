import { onScopeDispose } from 'vue';

import type { RunParts } from '../../session/run/parts';
import type { CountDown } from './count-down';

/** Elements in which Space has another meaning; `TEXT`: those in which all of the keys do. */
const OWN_SPACE =
  'button, a, input, textarea, select, summary, [role="menu"], [role="slider"], [contenteditable="true"]';
const TEXT = 'input, textarea, select, [contenteditable="true"], [role="menu"]';

/**
 * The keys of a presenter, also with the small remote of a slide show: Space or page down starts the run, Space pauses it
 * and lets it go on, page up leads back to the start, T starts and pauses the timer.
 */
export function usePresenterKeys({ run, hand }: Pick<RunParts, 'run' | 'hand'>, countDown: CountDown): void {
  const acts: Readonly<Record<string, () => void>> = {
    ' ': () => {
      if (run.phase.value === 'paused') run.resume();
      else if (run.phase.value === 'running' && !run.isOver.value) run.pause();
      else run.press();
    },
    pagedown: () => run.press(),
    pageup: () => {
      hand.reset();
      void run.reset();
    },
    t: () => (countDown.phase.value === 'running' ? countDown.pause() : countDown.start()),
  };
  function down(event: KeyboardEvent): void {
    const act = acts[event.key.toLowerCase()];
    if (act === undefined || event.defaultPrevented || event.repeat || isCommand(event)) return;
    // A look back has keys of its own for time, a menu for its entries.
    if (run.past.value !== null && event.key.toLowerCase() !== 't') return;
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest(event.key === ' ' ? OWN_SPACE : TEXT)) return;
    event.preventDefault();
    act();
  }
  addEventListener('keydown', down);
  onScopeDispose(() => removeEventListener('keydown', down));
}

const isCommand = ({ ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): boolean =>
  ctrlKey || metaKey || altKey || shiftKey;
