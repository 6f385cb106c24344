import type { HexBoard } from '#hex/firmware';

/** The ways by which a program gets onto a real board; single files can always be saved beside them. */
export const WAYS = ['usb', 'hex', 'serial'] as const;
export type Way = (typeof WAYS)[number];

/** The devices that pupils sit at, as far as their ways differ. An iPhone is like an iPad. */
export type Platform = 'computer' | 'chromebook' | 'android' | 'ipad';

/** Whether the page can use an interface. `browser`: the browser has none; `frame`: the frame around it does not allow it. */
export type Ability = 'yes' | 'browser' | 'frame';

/** The facts on which the choice of ways depends. */
export interface WayFacts {
  readonly platform: Platform;
  readonly usb: Ability;
  readonly serial: Ability;
  readonly board: HexBoard;
  /** True if a MicroPython for this board is at hand. */
  readonly hasFirmware: boolean;
  /** The way that worked last in this browser. */
  readonly last: Way | null;
}

/** Why a way is closed: this kind of device cannot, this browser cannot, the frame forbids it, the board has no such chip. */
export type Hindrance = 'device' | Exclude<Ability, 'yes'> | 'board';

/** A way as the dialog shows it; `firmware` asks for the MicroPython that the ways need whose place it takes. */
export interface OfferedWay {
  readonly way: Way | 'firmware';
  readonly hindrance: Hindrance | null;
}

/**
 * The ways in the order in which they are offered: first the one that worked last, then the quickest; those that are
 * closed stand at the end with the reason.
 */
export function offeredWays(facts: WayFacts): readonly OfferedWay[] {
  const all = quickest(facts.platform).map((way) => ({ way, hindrance: hindranceOf(way, facts) }));
  const open = all.filter(({ hindrance }) => hindrance === null);
  const first = open.filter(({ way }) => way === facts.last);
  const sorted = [...first, ...open.filter(({ way }) => way !== facts.last)];
  return [...(facts.hasFirmware ? sorted : withoutFirmware(sorted)), ...closed(all)];
}

/** On a phone or tablet the app by Bluetooth comes before a cable, for which most have no adapter. */
const quickest = (platform: Platform): readonly Way[] =>
  platform === 'android' || platform === 'ipad' ? ['hex', 'usb', 'serial'] : ['usb', 'hex', 'serial'];

function hindranceOf(way: Way, { platform, usb, serial, board }: WayFacts): Hindrance | null {
  if (way === 'hex') return null;
  if (platform === 'ipad') return 'device';
  if (way === 'serial') return serial === 'yes' ? null : serial;
  if (usb !== 'yes') return usb;
  return board === 'calliope-mini-1' ? 'board' : null; // its interface chip is another one, of SEGGER's
}

/** One question in the place of all ways that need the answer. */
function withoutFirmware(open: readonly OfferedWay[]): readonly OfferedWay[] {
  const place = open.findIndex(({ way }) => way !== 'serial');
  return open.flatMap((offer, at): readonly OfferedWay[] =>
    at === place ? [{ way: 'firmware', hindrance: null }] : offer.way === 'serial' ? [offer] : [],
  );
}

/** Two ways that are closed for the same reason are told once. */
function closed(all: readonly OfferedWay[]): readonly OfferedWay[] {
  const shut = all.filter(({ hindrance }) => hindrance !== null);
  return shut.filter(({ way, hindrance }) => way === 'usb' || !shut.some((it) => it.way === 'usb' && it.hindrance === hindrance)); // prettier-ignore
}

/** The guides from a saved hex to the board. */
export const GUIDES = ['drive', 'chromebook', 'microbit-ipad', 'microbit-android', 'calliope-ipad', 'calliope-android'] as const; // prettier-ignore
export type Guide = (typeof GUIDES)[number];

/** The guide for this device and board. */
export function guideFor(platform: Platform, board: HexBoard): Guide {
  if (platform === 'computer') return 'drive';
  if (platform === 'chromebook') return 'chromebook';
  return `${board.startsWith('calliope') ? 'calliope' : 'microbit'}-${platform}`;
}

/** The name of the drive as which a board appears. */
export const driveOf = (board: HexBoard): string => (board.startsWith('calliope') ? 'MINI' : 'MICROBIT');
