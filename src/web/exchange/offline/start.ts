import { keepOffline } from './keep-offline';
import { lateBar } from './late-bar';

/**
 * Keeps the app for visits without a network, and warns if the browser can store no work.
 *
 * @param keepsWork whether the work is to be kept here, and not by a page around this one
 */
export async function startOffline(keepsWork: boolean): Promise<void> {
  if (keepsWork && !canStore()) {
    void lateBar(({ sayNoStorage }) => sayNoStorage());
  }
  await keepOffline();
}

/** True if the browser lets this page keep anything: frames and private windows may not. */
function canStore(): boolean {
  const KEY = 'parcours.probe';
  try {
    for (const store of [sessionStorage, localStorage]) {
      store.setItem(KEY, '');
      store.removeItem(KEY);
    }
    return true;
  } catch {
    return false;
  }
}
