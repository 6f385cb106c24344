import { clipOf } from '../clip-text';
import type { Clip } from '../clipboard';

/** The parts on the shelf, by purpose; each name is that of a file in `ready`. */
export const readyGroups = {
  lines: ['straight', 'long', 'curve', 'lane-change', 'corner', 'zigzag', 'gap', 'crossing', 'junction'],
  walls: ['cell', 'corridor', 'garage', 'gate', 'slalom'],
  fields: ['bay', 'start-box', 'sensor-strip'],
  things: ['lamp', 'traffic-light', 'barrier', 'ball', 'tunnel', 'tag'],
} as const;

export type ReadyGroup = keyof typeof readyGroups;
/** The name of a ready part. */
export type ReadyName = (typeof readyGroups)[ReadyGroup][number];

/** Each is the clipboard's text for the copied part: draw one, copy it, and paste it into a new file. */
const files = import.meta.glob<string>('./ready/*.json', { query: '?raw', import: 'default', eager: true });

/** A ready part at true size. */
export function readyPart(name: ReadyName): Clip {
  const clip = clipOf(files[`./ready/${name}.json`] ?? '');
  if (clip === null) throw new Error(`The part ${name} holds no objects.`);
  return clip;
}
