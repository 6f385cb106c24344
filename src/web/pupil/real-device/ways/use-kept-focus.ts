import { nextTick, watch } from 'vue';

/**
 * Keeps the keyboard in the dialog: when the pressed button is gone or has changed, it goes to the next one in the foot,
 * to the one marked as `data-first` before the main one.
 *
 * @param state changes with the buttons; `choosing`: the keyboard is in the browser's own list then
 */
export function useKeptFocus(foot: () => HTMLElement | null, state: () => string): void {
  watch(state, async (now) => {
    await nextTick();
    const card = foot()?.closest('.dialog-card') ?? null;
    const active = document.activeElement;
    const isKept = card?.contains(active) === true && active?.matches(':disabled') === false;
    if (now === 'choosing' || isKept || (active !== document.body && !card?.contains(active))) return;
    const buttons = ['[data-first]', '.ink', 'button'].map((css) => foot()?.querySelector<HTMLElement>(`${css}:not(:disabled)`)); // prettier-ignore
    buttons.find((button) => button instanceof HTMLElement)?.focus();
  });
}
