/** The texts of the bar. It loads with the first message: `import('…/messages')`. */
import words from '../words/bar';
import { closePageBar, showPageBar } from './page-bar';

/** A new version of the app is ready, and waits for a yes. */
export function offerUpdate(accept: () => void): void {
  showPageBar({
    kind: 'update',
    text: words.update,
    actions: [{ text: words.reload, run: accept }],
    close: words.later,
  });
}

/** The new version is none any more. */
export const takeBackUpdate = (): void => closePageBar('update');

/** The browser keeps nothing here. */
export const sayNoStorage = (): void =>
  showPageBar({ kind: 'no-storage', text: words.noStorage, actions: [], close: words.close });

/** A frame may have refused a download or printing. */
export const sayRefusal = (): void =>
  showPageBar({ kind: 'may-be-refused', text: words.mayBeRefused, actions: [], close: words.close });
