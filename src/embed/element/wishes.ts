import { LANGUAGES } from '#core/texts';
import type { Parcours } from '../client/types';
import { limits } from '../parcours/limits';
import { PARTS, type HostSpeed } from '../simulator';
import { isOn } from './address';

/** How an attribute's new value reaches a page that is there. `null` is an attribute that is gone: as at first. */
type Wish = (parcours: Parcours, value: string | null) => Promise<void>;

const SPEEDS: readonly HostSpeed[] = [0.25, 0.5, 1, 2, 4, 8, 'max'];
const THEMES = ['system', 'light', 'dark'] as const;

/** Attributes that change the page while it is there. */
export const wishes: Readonly<Record<string, Wish>> = {
  show(parcours, value) {
    const names: readonly string[] = value?.split(/[\s,]+/) ?? [];
    const some = PARTS.filter((part) => names.includes(part));
    return parcours.setSettings({ parts: some.length === 0 || names.includes('all') ? PARTS : some });
  },
  async lang(parcours, value) {
    // A language that the page does not have changes nothing, and neither does none.
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

/** Snapshots per second that the attribute asks for, 0 … 60; what is no number asks for none. */
export function snapshotHzOf(value: string | null): number {
  const hz = Number(value ?? 0);
  return Number.isNaN(hz) ? 0 : Math.min(limits.snapshotHz, Math.max(0, hz));
}

/** Those of them that a project brings as well: where an attribute says something, it counts. */
export const ABOVE_PROJECT = ['robot', 'board', 'seed', 'reality'] as const;
