import type { Option } from '#core/option';
import { inEvery } from '#core/words';
import words from './words';

/** Titles of the attachments for a servo port, by id, the most usual first; `none` leaves it empty. */
export const attachmentTitles = words;

/** The options of a robot's servo ports: what hangs on each. Light: the page loads it before anything runs. */
export function attachmentOptions(ports: readonly string[]): readonly Option[] {
  const choices = Object.entries(attachmentTitles).map(([id, title]) => ({ id, title }));
  return ports.map((port) => ({ id: port, title: inEvery(() => `Servo ${port}`), choices }));
}
