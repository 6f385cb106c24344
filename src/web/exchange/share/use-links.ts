import { onMounted, onScopeDispose } from 'vue';

import type { Part } from '#embed/simulator';

import type { VisitParts } from '../../session/visit/parts';
import type { Workplace } from '../../session/work/model/parts';
import { hostWish, parametersOf } from '../../session/visit/address';
import { heldSettings } from '../../session/visit/held-settings';
import { latePart } from '../../kit/late-part';

/** Parameters that carry work: a program (WebTigerPython's, or one in a course of ours), or a course. */
const OPENED = ['code', 'fs', 'world', 'task'] as const;
/** The parameters that bring a program from outside, as our own links also do. */
const PROGRAMS: readonly string[] = ['code', 'fs'];

/**
 * Opens the link with which the page was called, and those that follow; nothing runs. Once it is open, the address is
 * that of the app again. Its other parameters stay for a reload, which brings the work back as the pupil left it.
 */
export function useLinks(app: Workplace & VisitParts): void {
  const { settings, host } = app;

  function follow(): void {
    const { href } = location;
    const given = parametersOf(location);
    const isProject = /^#[pr]=/.test(location.hash);
    const opened = OPENED.filter((name) => given.has(name));
    if (!isProject && opened.length === 0) {
      hold();
      return;
    }
    import('./open-address')
      .then(({ openAddress }) => {
        const problem = openAddress(app, href, 'held');
        hold();
        app.work.isBrought ||= problem === null;
        if (problem === null) app.work.arrivals.value += 1;
        if (problem !== null) refuse(problem);
        else if (isProject || opened.some((name) => PROGRAMS.includes(name))) showSource();
        else clearAddress();
      })
      .catch(() => app.notices.show(latePart));
  }
  /** The other settings in the address hold for this visit, also against the opened project. */
  function hold(): void {
    const { settings: wish } = hostWish(location, document.documentElement.dataset);
    settings.hold(heldSettings(wish));
    if (wish.parts !== undefined) host.parts.value = wish.parts;
  }
  /** A stranger's program is shown before it runs, whatever its link hides. In a frame, the embedding page decides. */
  function showSource(): void {
    const parts = host.parts.value;
    if (parts === null || parts.includes('code') || window.parent !== window) {
      clearAddress();
      return;
    }
    host.parts.value = [...parts, 'code'];
    clearAddress(host.parts.value);
  }
  function refuse(text: string): void {
    app.notices.show({ kind: 'error', key: 'notice.text', values: { text } });
    clearAddress();
  }
  onMounted(follow);
  addEventListener('hashchange', follow);
  onScopeDispose(() => removeEventListener('hashchange', follow));
}

/** Takes what was opened out of the address; the other parameters stay. @param show the parts that it shows from now on */
function clearAddress(show?: readonly Part[]): void {
  const query = new URLSearchParams(location.search);
  const fragment = new URLSearchParams(location.hash.startsWith('#?') ? location.hash.slice(2) : '');
  for (const name of OPENED) {
    query.delete(name);
    fragment.delete(name);
  }
  if (show !== undefined) {
    fragment.delete('show');
    query.set('show', show.join(','));
  }
  const following = (sign: string, given: URLSearchParams): string => {
    const text = given.toString();
    return text === '' ? '' : sign + text;
  };
  history.replaceState(history.state, '', location.pathname + following('?', query) + following('#?', fragment));
}
