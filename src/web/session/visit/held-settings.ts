import { PARTS, type HostSettings, type Part } from '#embed/simulator';

import type { Settings } from '../work/settings/settings';

/** The app's own settings among those of a host. */
export function heldSettings(wish: HostSettings): Partial<Settings> {
  const { parts, ...others } = wish;
  const own = Object.entries(others).filter(([name]) => name !== 'labels');
  const shown: Partial<Settings> =
    parts === undefined ? {} : { showBoard: true, showArena: true, showTools: toolsIn(parts) };
  return { ...Object.fromEntries(own), ...shown };
}

/**
 * True if the tools are among the parts; `null` if all parts are, but perhaps the bar: then the tools are unfolded
 * where they have room, as without a host.
 */
const toolsIn = (parts: readonly Part[]): boolean | null => {
  const isWhole = PARTS.every((part) => part === 'bar' || parts.includes(part));
  return isWhole ? null : parts.includes('tools');
};
