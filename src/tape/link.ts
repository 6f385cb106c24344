/**
 * A recorded run as the part of an address behind `#`, looked at from one of its moments:
 *
 *     r=1.12340.<base64url>   1: version of all that follows; 12340: the moment, in ms
 *     <base64url>             checksum of all that follows (4 bytes, FNV-1a, lowest first), the file of the run, deflated
 *
 * Only A–Z a–z 0–9 - _ . = occur, which link detectors accept.
 */
import { packed, unpacked } from '#core/deflate';
import { sealed, unsealed } from '#core/sealed';

/** The version of links to runs that this app makes and the newest that it reads. */
export const RUN_LINK_VERSION = 1;

/** Longest link that is made. Chosen: chats and mail programs cut longer ones, and a cut run is none. */
export const RUN_LINK_CHARACTERS = 8_000;

/** Longest link that is read, and the most that it may unpack to. Chosen: far beyond what is made. */
const MOST_READ = 500_000;
const UNPACKED_BYTES = 4_000_000;

/** The content of a link, or the reason why it has none. */
export type ReadRunLink = { readonly text: string; readonly atUs: number } | { readonly fault: 'damaged' | 'newer' };

/** True if the part of an address behind `#` says that it is a link to a run. */
export const isRunLink = (fragment: string): boolean => /^#?r=/.test(fragment);

/** The link to a run. @param text the run's file @param atUs the moment from which it is looked at */
export function runLinkOf(text: string, atUs: number): string {
  const bytes = packed(new TextEncoder().encode(text));
  return `r=${RUN_LINK_VERSION}.${Math.round(atUs / 1000)}.${sealed(bytes)}`;
}

/** Reads the part of an address behind `#`, with or without it. Never throws. */
export function readRunLink(fragment: string): ReadRunLink {
  const [, known] = /^#?r=(\d{1,9})\./.exec(fragment.trim()) ?? [];
  if (Number(known) > RUN_LINK_VERSION) return { fault: 'newer' };
  const [, version, ms, data] = /^#?r=(\d{1,9})\.(\d{1,12})\.([\w-]+)=*$/.exec(fragment.trim()) ?? [];
  if (version !== String(RUN_LINK_VERSION) || data === undefined || data.length > MOST_READ)
    return { fault: 'damaged' };
  const bytes = unsealed(data);
  if (bytes === null) return { fault: 'damaged' };
  const text = unpacked(bytes, UNPACKED_BYTES);
  if (typeof text === 'string') return { fault: 'damaged' };
  return { text: new TextDecoder().decode(text), atUs: Number(ms) * 1000 };
}
