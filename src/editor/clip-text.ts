import { parseScene } from '#scene/parse';
import { defaultScene, sceneLimits } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import type { Clip } from './clipboard';

/** Distinguishes copied objects from any other text. */
const FORMAT = 'parcours-objects';

/** Copied objects as a text for the system's clipboard: a course file with nothing else in it, under a mark of its own. */
export const clipText = ({ objects }: Clip): string =>
  `{"format": "${FORMAT}", "course": ${serializeScene({ ...defaultScene(), objects }).trim()}}`;

/** The objects of a text from a clipboard, read like those of a course file; `null`: it holds none. */
export function clipOf(text: string): Clip | null {
  if (text.length > sceneLimits.textCharacters || !text.includes(FORMAT)) return null;
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value !== 'object' || value === null || !('format' in value) || !('course' in value)) return null;
    if (value.format !== FORMAT) return null;
    const read = parseScene(JSON.stringify(value.course));
    return 'scene' in read && read.scene.objects.length > 0 ? { objects: read.scene.objects } : null;
  } catch {
    return null; // not JSON
  }
}
