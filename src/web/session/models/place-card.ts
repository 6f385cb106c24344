import { computed, watch } from 'vue';

import { hasFeedback } from '#check/feedback/has-feedback';

import type { SessionParts } from './session';

type Parts = Pick<SessionParts, 'task' | 'layout' | 'mode' | 'settings' | 'work'>;

/**
 * Gives the card its place in the layout: beside the program while the robot drives. A teacher's feedback is about the past:
 * there its card stays.
 */
export function placeCard({ task, layout, mode, settings, work }: Parts): void {
  const card = computed(() => {
    const { project } = work.work.value;
    const isPlace = mode.current.value === 'drive' || (mode.current.value === 'lookBack' && hasFeedback(project));
    if (!isPlace || !layout.parts.value.includes('arena')) return null;
    if (layout.isGreeting.value) return task.isUnfolded.value ? 'open' : 'folded';
    return task.card.value;
  });
  watch(card, (form) => (layout.card.value = form), { immediate: true, flush: 'sync' });
  // A phone has the course behind a tab: card and course are read together.
  const bringToFront = (): void => {
    // Also where the window is too low for more than its title line.
    const isMeant = layout.card.value !== null && settings.current.value.showCard;
    const isRead = isMeant && layout.tabs.value.includes('arena');
    if (isRead && layout.arrangement.value === 'phone') layout.tab.value = 'arena';
  };
  watch([work.openings, work.arrivals], bringToFront);
  watch(layout.isGreeting, (isGreeting) => isGreeting && bringToFront(), { flush: 'sync' });
}
