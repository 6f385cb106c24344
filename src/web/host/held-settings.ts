import type { HostSettings } from '#embed/simulator';

import type { Settings } from '../project/settings';

/** The part of a host's settings that are the app's own settings. */
export function heldSettings(wish: HostSettings): Partial<Settings> {
  const { parts, ...others } = wish;
  const own = Object.entries(others).filter(([name]) => name !== 'labels');
  const shown: Partial<Settings> =
    parts === undefined ? {} : { showBoard: true, showArena: true, showTools: parts.includes('tools') };
  return { ...Object.fromEntries(own), ...shown };
}
