import { sha256 } from '@noble/hashes/sha2.js';

import type { Project } from '#project/project';

/** Signs that nobody takes for another: neither I nor 1, neither O nor 0. */
const SIGNS = 'ABCDEFGHJKLMNPQRSTUVWXYZ23456789';
/** Chosen: who changes a program afterwards would need a thousand million tries to meet the same code. */
const LENGTH = 6;

/**
 * A short code of the programs that are handed in, of all devices: the pupil shows it when the time is over, and the
 * teacher's page has the same one as long as nobody has changed them. Ends of lines do not matter.
 */
export function handInCode({ files, devices }: Pick<Project, 'files' | 'devices'>): string {
  const programs = [files, ...(devices?.others.map((device) => device.files) ?? [])];
  const plain = programs.map((list) => list.map(({ name, text }) => [name, text.replaceAll('\r\n', '\n')]));
  const bytes = sha256(new TextEncoder().encode(JSON.stringify(plain)));
  return Array.from(bytes.subarray(0, LENGTH), (byte) => SIGNS.charAt(byte % SIGNS.length)).join('');
}
