import { PARTS, type HostSettings, type Part } from '#embed/simulator';

import type { Settings } from '../work/settings/settings';
import type { HostWish } from './host-view';

/** The app's own settings among those of a host. */
export function heldSettings(wish: HostSettings): Partial<Settings> {
  const { parts, ...others } = wish;
  const own = Object.entries(others).filter(([name]) => name !== 'labels');
  const shown: Partial<Settings> =
    parts === undefined ? {} : { showBoard: true, showArena: true, showTools: toolsIn(parts) };
  return { ...Object.fromEntries(own), ...shown };
}

/** The settings that a page begins with: those of its host or address, and the mode that they want. */
export const heldByWish = ({ settings, mode }: Pick<HostWish, 'settings' | 'mode'>): Partial<Settings> => ({
  ...heldSettings(settings),
  ...(mode !== null && { showTools: mode === 'build' }),
});

/**
 * True if the tools are among the parts, and not all the others: then the page begins with building.
 */
const toolsIn = (parts: readonly Part[]): boolean => {
  const isWhole = PARTS.every((part) => part === 'bar' || parts.includes(part));
  return !isWhole && parts.includes('tools');
};
