import type { Part } from '#embed/simulator';

import type { VisitParts } from '../../session/visit/parts';
import type { Workplace } from '../../session/work/model/parts';
import { elsewhereOf } from '../elsewhere/parts';
import { LINK_PARAMETERS } from './link-parameters';
import { openAddress } from './open-address';

/** A link with work in it. */
export interface GivenLink {
  readonly href: string;
  /** True if it brings a program from outside. */
  readonly hasProgram: boolean;
}

/** The page that a link is opened on; `hold` lets the other settings in the address hold for this visit. */
type LinkedPage = Workplace & VisitParts & { readonly hold: () => void };

/** Opens a link and takes it out of the address, or says why not. */
export function followLink(app: LinkedPage, { href, hasProgram }: GivenLink): void {
  const problem = openAddress(app, href, 'held');
  app.hold();
  app.work.isBrought ||= problem === null;
  // A program from elsewhere has nothing to do with the task that is open: its own card is the one to read.
  if (problem === null && elsewhereOf(app).brought.shown.value === null) app.work.arrivals.value += 1;
  if (problem !== null) {
    app.notices.show({ kind: 'error', key: 'notice.text', values: { text: problem } });
    clearAddress();
  } else if (hasProgram) showSource(app);
  else clearAddress();
}

/** A stranger's program is shown before it runs, whatever its link hides. In a frame, the embedding page decides. */
function showSource({ host }: VisitParts): void {
  const parts = host.parts.value;
  if (parts === null || parts.includes('code') || window.parent !== window) {
    clearAddress();
    return;
  }
  host.parts.value = [...parts, 'code'];
  clearAddress(host.parts.value);
}

/** Takes what was opened out of the address. @param show the parts that it shows from now on */
const clearAddress = (show?: readonly Part[]): void =>
  history.replaceState(history.state, '', addressWithoutLink(location, show));

type AddressParts = Pick<Location, 'pathname' | 'search' | 'hash'>;

/** An address without the work that it brings; its other parameters and its page stay, so that closing a window leads back to it. */
export function addressWithoutLink({ pathname, search, hash }: AddressParts, show?: readonly Part[]): string {
  const query = new URLSearchParams(search);
  const fragment = new URLSearchParams(hash.startsWith('#?') ? hash.slice(2) : '');
  for (const name of LINK_PARAMETERS) {
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
  const page = /^#(\?|[pr]=)/.test(hash) ? '' : hash;
  return pathname + following('?', query) + (following('#?', fragment) || page);
}
