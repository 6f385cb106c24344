/** The texts of the bar. It loads with the first message: `import('…/messages')`. */
import words from '../words/bar';
import { closePageBar, showPageBar } from './page-bar';

/** Says that a new version of the app is ready. @param accept called when the user wants it now */
export function offerUpdate(accept: () => void): void {
  showPageBar({
    kind: 'update',
    text: words.update,
    actions: [{ text: words.reload, run: accept }],
    close: words.later,
  });
}

/** Takes the offer of a new version back. */
export const takeBackUpdate = (): void => closePageBar('update');

/** Says that the browser stores nothing here. */
export const sayNoStorage = (): void =>
  showPageBar({ kind: 'no-storage', text: words.noStorage, actions: [], close: words.close });

/** Says that the frame may have refused a download or printing. */
export const sayRefusal = (): void =>
  showPageBar({ kind: 'may-be-refused', text: words.mayBeRefused, actions: [], close: words.close });
