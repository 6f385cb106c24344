import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import words from './words';

/** The address of the page for teachers. */
export const DESK = 'teachers';

/** The arrow that leads from a page for teachers back to the one with all cards. */
export function useBackToDesk(): { readonly label: () => string; readonly back: () => void } {
  const { router } = useLayout();
  return { label: () => t(words.title), back: () => router.up(DESK) };
}
