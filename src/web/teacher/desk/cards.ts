import type { ShallowRef } from 'vue';

import { DESK_PARTS, type DeskCard, type DeskCards } from '../../kit/features/desk-card';
import { collected } from '../../kit/features/feature';

/** The cards of all features: each brings a `desk-cards.ts`. */
const deskCards: readonly DeskCards[] = collected(
  import.meta.glob<DeskCards>('../../**/desk-cards.ts', { eager: true, import: 'deskCards' }),
);

/** The cards by the parts of a lesson, in their order; called in a set-up. */
export function useCards(
  search: Readonly<ShallowRef<string>>,
): readonly { readonly part: DeskCard['part']; readonly cards: readonly DeskCard[] }[] {
  const all = deskCards.flatMap((cards) => cards(search));
  return DESK_PARTS.map((part) => ({
    part,
    cards: all.filter((card) => card.part === part).sort((one, other) => one.order - other.order),
  }));
}
