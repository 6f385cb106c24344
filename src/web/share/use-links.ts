import { onMounted, onScopeDispose } from 'vue';

import type { App } from '../composables/use-app';

/** Addresses that have work in them: our own links (`#p=…`), and those of WebTigerPython (`?code=…`, `#?code=…`). */
const hasWork = ({ hash, search }: Location): boolean => hash.startsWith('#p=') || /[?&]code=/.test(search + hash);

/**
 * Opens the link with which the page was called, and those that follow. Once it is open, the address is that of the app
 * again: a reload shows the work as it is then.
 */
export function useLinks(app: App): void {
  function follow(): void {
    if (!hasWork(location)) return;
    const { href } = location;
    import('./open-address')
      .then(({ openAddress }) => {
        const problem = openAddress(app, href);
        if (problem === null) clearAddress();
        else refuse(problem);
      })
      .catch(() => app.notices.show({ kind: 'error', key: 'notice.firmware' }));
  }
  function refuse(text: string): void {
    app.notices.show({ kind: 'error', key: 'notice.text', values: { text } });
    clearAddress();
  }
  onMounted(follow);
  addEventListener('hashchange', follow);
  onScopeDispose(() => removeEventListener('hashchange', follow));
}

/** Takes what was opened out of the address; other parts of the query stay. */
function clearAddress(): void {
  const query = new URLSearchParams(location.search);
  for (const name of ['code', 'device']) query.delete(name);
  const rest = query.toString();
  history.replaceState(history.state, '', location.pathname + (rest === '' ? '' : `?${rest}`));
}
