import { unread } from '#check/hand-in/unread';
import { isSeriesLink, seriesOfLink } from '#check/series/series-link';
import { DAMAGED_LINK, isProjectLink, projectOfLink, type LinkProblem, type ReadyCourses } from '#project/link/link';
import { isProgramLink, type ProgramLinkProblem } from '#project/webtigerpython/program-link';
import { isRunLink, readRunLink } from '#tape/link';
import { unreadable, type AddressDocument, type ReadyDocument, type SeriesDocument, type Unreadable } from './document';
import { seriesDocument } from './text';
import { documentOfProgramLink } from './webtigerpython';

/**
 * Reads an address, ours or one of WebTigerPython, whole or only its query or fragment: a project, a run, a program, perhaps
 * with its world or in a ready course, a world or a ready course alone, or where a series is. Never throws.
 */
export function documentOfAddress(text: string, courses: ReadyCourses): AddressDocument {
  const address = text.trim();
  const fragment = fragmentOf(address);
  if (isProjectLink(fragment)) {
    const read = projectOfLink(fragment, courses);
    return 'problem' in read ? badLink(read.problem) : { kind: 'project', ...read };
  }
  if (isRunLink(fragment)) {
    const read = readRunLink(fragment);
    return 'fault' in read ? badLink(read.fault === 'newer' ? NEWER : DAMAGED) : { kind: 'recording', ...read };
  }
  const link = seriesLinkOf(address);
  if (link !== null) return { kind: 'series-link', link };
  const [, place] = /^#?series=(.+)$/.exec(fragment) ?? [];
  if (place !== undefined) return { kind: 'series-place', place };
  const ready = readyIn(address);
  if (isProgramLink(address)) {
    const read = documentOfProgramLink(address, ready?.course ?? null);
    return 'problem' in read ? badLink(read.problem) : read;
  }
  return ready ?? unreadable(unread('no-work').problem);
}

/** The series in a link from `s=` on. Never throws. */
export function documentOfSeriesLink(link: string, courses: ReadyCourses): SeriesDocument | Unreadable {
  const read = seriesOfLink(link, courses);
  if (!('fault' in read)) return seriesDocument(read);
  const { fault } = read;
  const problem = unread(fault === 'newer' ? 'newer-link' : 'link');
  return { kind: 'unreadable', ...problem, message: SERIES_FAULTS[fault], problems: [], seriesLink: fault };
}

const fragmentOf = (address: string): string => address.slice(Math.max(address.indexOf('#'), 0));

/** The link of a series in an address, from `s=` on; `null`: there is none. */
export function seriesLinkOf(address: string): string | null {
  const fragment = fragmentOf(address);
  return isSeriesLink(fragment) ? fragment.slice(fragment.startsWith('#') ? 1 : 0) : null;
}

/** The ready course that an address names: a task before an arena, in the query before the fragment. */
function readyIn(address: string): ReadyDocument | null {
  for (const name of ['task', 'world']) {
    const [, value] = new RegExp(`[?&]${name}=([^&#]*)`).exec(address) ?? [];
    if (value !== undefined) return { kind: 'ready', course: decoded(value), isWhole: name === 'task' };
  }
  return null;
}

function decoded(value: string): string {
  try {
    return decodeURIComponent(value.replaceAll('+', ' '));
  } catch {
    return value;
  }
}

function badLink(link: LinkProblem | ProgramLinkProblem): Unreadable {
  const code = link.code === 'newer-version' ? 'newer-link' : 'link';
  return { kind: 'unreadable', ...unread(code), message: link.message, problems: link.problems, link };
}

const NEWER_LINK = 'The link is from a newer version. Update Parcours.';
const DAMAGED: LinkProblem = { code: 'damaged', message: DAMAGED_LINK, params: {}, problems: [] };
const NEWER: LinkProblem = { code: 'newer-version', message: NEWER_LINK, params: {}, problems: [] };

/** The messages for faults of a series link itself, apart from those of the series in it. */
const SERIES_FAULTS = {
  damaged: DAMAGED_LINK,
  newer: NEWER_LINK,
  'too-large': 'The link holds far too much and is not opened.',
} as const;
