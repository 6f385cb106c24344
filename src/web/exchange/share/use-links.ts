import { onMounted, onScopeDispose } from 'vue';

import type { VisitParts } from '../../session/visit/parts';
import type { Workplace } from '../../session/work/model/parts';
import { hostWish, parametersOf } from '../../session/visit/address';
import { heldSettings } from '../../session/visit/held-settings';
import { latePart } from '../../kit/late-part';
import { LINK_PARAMETERS } from './link-parameters';

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
    const opened = LINK_PARAMETERS.filter((name) => given.has(name));
    if (!isProject && opened.length === 0) {
      hold();
      return;
    }
    import('./follow-link')
      .then(({ followLink }) => {
        const hasProgram = isProject || opened.some((name) => PROGRAMS.includes(name));
        followLink({ ...app, hold }, { href, hasProgram });
      })
      .catch(() => app.notices.show(latePart));
  }
  /** The other settings in the address hold for this visit, also against the opened project. */
  function hold(): void {
    const { settings: wish } = hostWish(location, document.documentElement.dataset);
    settings.hold(heldSettings(wish));
    if (wish.parts !== undefined) host.parts.value = wish.parts;
  }
  onMounted(follow);
  addEventListener('hashchange', follow);
  onScopeDispose(() => removeEventListener('hashchange', follow));
}
