import { LANGUAGES } from '#core/languages';
import { SPEEDS } from '#simulation/pace';
import type { Parcours } from '../client/types';
import { limits } from '../parcours/limits';
import { PARTS } from '../simulator';
import { isOn } from './address';
import { THEMES } from './attribute-problem';

/** Sends an attribute's new value to a running page. `null`: the attribute was removed, back to the default. */
type Wish = (parcours: Parcours, value: string | null) => Promise<void>;

/** Attributes that change a running page. */
export const wishes: Readonly<Record<string, Wish>> = {
  show(parcours, value) {
    const names: readonly string[] = value?.split(/[\s,]+/) ?? [];
    const some = PARTS.filter((part) => names.includes(part));
    return parcours.setSettings({ parts: some.length === 0 || names.includes('all') ? PARTS : some });
  },
  async lang(parcours, value) {
    // An unknown language changes nothing, and neither does a missing one.
    const language = LANGUAGES.find((one) => one === value?.slice(0, 2).toLowerCase());
    if (language !== undefined) await parcours.setSettings({ language });
  },
  theme: (parcours, value) => parcours.setSettings({ theme: THEMES.find((one) => one === value) ?? 'system' }),
  muted: (parcours, value) => parcours.setSettings({ muted: isOn(value) }),
  speed: (parcours, value) => parcours.setSpeed(SPEEDS.find((one) => String(one) === value) ?? 1),
  robot: (parcours, value) => parcours.setRobot({ robot: value ?? 'auto' }),
  board: (parcours, value) => parcours.setRobot({ device: value ?? 'auto' }),
  seed: (parcours, value) => parcours.setSeed(Number(value ?? 1)),
  reality: (parcours, value) => parcours.setReality(Number(value ?? 0)),
  'snapshot-hz': (parcours, value) => parcours.subscribe({ snapshotHz: snapshotHzOf(value) }),
};

/** Requested snapshots per second, 0 … 60; 0 for anything but a number. */
export function snapshotHzOf(value: string | null): number {
  const hz = Number(value ?? 0);
  return Number.isNaN(hz) ? 0 : Math.min(limits.snapshotHz, Math.max(0, hz));
}

/** The attributes whose settings a project has as well: an attribute that is set wins. */
export const ABOVE_PROJECT: readonly string[] = ['robot', 'board', 'seed', 'reality'];
