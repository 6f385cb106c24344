import { shallowRef, type Ref } from 'vue';

import { feedbackLimits } from '#check/feedback/feedback';

import { lateModel } from '../../../kit/state/late-models';
import type { VisitParts } from '../../../session/visit/parts';

/** The teacher's own sentences for notes, the oldest first. They stay in this browser. */
export interface OwnBlocks {
  readonly all: Readonly<Ref<readonly string[]>>;
  /** Keeps a sentence; one that is there already, or is empty, is not kept twice. */
  keep(text: string): void;
  forget(text: string): void;
}

const KEY = 'parcours.blocks';
/** Chosen: more buttons than anybody looks through; the oldest go first. */
const MOST = 20;

/** Loads the sentences. @param store storage for them; `null`: they last as long as the page is open */
export function createOwnBlocks(store: Storage | null): OwnBlocks {
  const all = shallowRef(read(store));
  function write(blocks: readonly string[]): void {
    all.value = blocks.slice(-MOST);
    try {
      if (all.value.length === 0) store?.removeItem(KEY);
      else store?.setItem(KEY, JSON.stringify(all.value));
    } catch {
      // No room or no permission: they hold as long as the page does.
    }
  }
  return {
    all,
    keep(text) {
      const block = text.trim().slice(0, feedbackLimits.noteCharacters);
      if (block !== '') write([...all.value.filter((one) => one !== block), block]);
    },
    forget: (text) => write(all.value.filter((one) => one !== text)),
  };
}

/** The stored sentences; unreadable ones count as none. */
function read(store: Storage | null): readonly string[] {
  try {
    const kept: unknown = JSON.parse(store?.getItem(KEY) ?? '[]');
    return Array.isArray(kept) ? kept.filter((one) => typeof one === 'string').slice(-MOST) : [];
  } catch {
    return [];
  }
}

/** The own sentences of a page. A page that keeps no work keeps none of them either. */
export const ownBlocksOf = lateModel(({ host }: VisitParts) => createOwnBlocks(storeOf(host.wish.keepsWork)));

function storeOf(keepsWork: boolean): Storage | null {
  try {
    return keepsWork ? localStorage : null;
  } catch {
    return null; // the browser forbids it
  }
}
