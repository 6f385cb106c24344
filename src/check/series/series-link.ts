/**
 * A series as the part of an address behind `#`, with all its tasks:
 *
 *     s=1.<base64url>   1: version of all that follows
 *     <base64url>       checksum of all that follows (`#core/sealed`), the file of the series, deflated
 *
 * Each task in it other than a ready course is a link to a project (`#project/link`), which is far shorter than its
 * file. Only A–Z a–z 0–9 - _ . = occur, which link detectors accept.
 */
import { packed, unpacked } from '#core/deflate';
import { sealed, unsealed } from '#core/sealed';
import { LINK_CHARACTERS, linkOf, projectOfLink, type ReadyCourses } from '#project/link/link';
import { aboutData } from '../task/about';
import { parseSeries, roomForLinks, SERIES_FORMAT, SERIES_VERSION, type ReadSeries } from './read-series';
import type { Series } from './series';

/** The version of links to series that this app makes, and the newest that it reads. */
export const SERIES_LINK_VERSION = 1;

/** The most that a link may unpack to, in bytes. */
const UNPACKED_BYTES = 4_000_000;

/** A link to a series. */
export interface MadeSeriesLink {
  /** The part of the address behind `#`. */
  readonly fragment: string;
  /** Places of the tasks whose pictures had no room. */
  readonly withoutPictures: readonly number[];
}

/** Contents of a link, or the reason why it has none. */
export type ReadSeriesLink = ReadSeries | { readonly fault: 'damaged' | 'newer' | 'too-large' };

/** True if the part of an address behind `#` claims to be a link to a series. */
export const isSeriesLink = (fragment: string): boolean => /^#?s=\d/.test(fragment);

/** Makes the link of a series whose files are all read; `null`: it would be too long, hold too much, or is not whole. */
export function seriesLinkOf({ id, title, text, tasks, about }: Series, courses: ReadyCourses): MadeSeriesLink | null {
  const withoutPictures: number[] = [];
  const entries: object[] = [];
  const room = roomForLinks();
  for (const [place, { from, ...task }] of tasks.entries()) {
    const said = { id: task.id, ...(task.title !== '' && { title: task.title }) };
    if (from.kind === 'course') entries.push({ ...said, course: from.course });
    else if (from.kind !== 'project') return null;
    else {
      const made = linkOf(from.project, { courses, program: true });
      if (made === null || room.left <= 0) return null;
      projectOfLink(made.fragment, courses, room);
      if (made.omitted.length > 0) withoutPictures.push(place);
      entries.push({ ...said, link: made.fragment });
    }
  }
  const file = {
    format: SERIES_FORMAT,
    version: SERIES_VERSION,
    id,
    title,
    ...(text !== '' && { text }),
    ...(about !== undefined && { about: aboutData(about) }),
    tasks: entries,
  };
  const bytes = new TextEncoder().encode(JSON.stringify(file));
  const fragment = `s=${String(SERIES_LINK_VERSION)}.${sealed(packed(bytes))}`;
  return bytes.length > UNPACKED_BYTES || fragment.length > LINK_CHARACTERS ? null : { fragment, withoutPictures };
}

/** Reads the part of an address behind `#`, with or without it. Never throws. */
export function seriesOfLink(fragment: string, courses: ReadyCourses): ReadSeriesLink {
  if (fragment.length > LINK_CHARACTERS) return { fault: 'too-large' };
  const [, version, data] = /^#?s=(\d{1,9})\.([\w-]+)=*$/.exec(fragment.trim()) ?? [];
  if (version === undefined || data === undefined) return { fault: 'damaged' };
  if (Number(version) !== SERIES_LINK_VERSION) return { fault: Number(version) > 1 ? 'newer' : 'damaged' };
  const bytes = unsealed(data);
  if (bytes === null) return { fault: 'damaged' };
  const text = unpacked(bytes, UNPACKED_BYTES);
  return typeof text === 'string' ? { fault: text } : parseSeries(new TextDecoder().decode(text), courses);
}
