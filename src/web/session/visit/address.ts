import { PARTS, type HostSettings, type Part } from '#embed/simulator';
import { flagOf, languageOf, partsOfLayout, PICTURE } from '#embed/webtigerpython/words';
import { deviceCalled } from '#project/webtigerpython/device-names';

import { SPEEDS } from '#simulation/pace';
import { isDevice, isRobotChoice } from '../work/settings/devices';
import { isSeed, THEMES } from '../work/settings/settings';
import type { HostWish } from './host-view';

type Address = Pick<Location, 'search' | 'hash'>;

/** The purpose of the page: the `data-…` attributes of its root element. */
type PageData = Readonly<Record<string, string | undefined>>;

/** Longest `show` and `flag` that are read, in characters, and the most of what can be given several times. */
const LONGEST = 1000; // chosen: nothing that has a meaning comes near
const MOST = 20; // chosen: for origins and flags

/** The parameters of the query, then those behind `#?` (WebTigerPython's newer form, that servers never see). */
export function parametersOf({ search, hash }: Address): URLSearchParams {
  return new URLSearchParams(`${search.slice(1)}&${hash.startsWith('#?') ? hash.slice(2) : ''}`);
}

/**
 * The settings in the page's address, and those of the page itself (`data-…` of its root element). Unknown parameters
 * are ignored; values that make no sense count as not given. If a parameter is given twice, the first one counts. None
 * of them starts a program: links from elsewhere open stopped.
 */
export function hostWish(address: Address, page: PageData): HostWish {
  const given = parametersOf(address);
  return {
    settings: settingsIn(given, page),
    mode: (['drive', 'build'] as const).find((one) => one === given.get('mode')) ?? null,
    dialect: dialectOf(given.get('dialect'), page['dialect']),
    keepsWork: page['keepsWork'] !== 'false',
    // A value that is not an origin belongs to nobody: it must not open the page to everybody.
    origins: given.getAll('origin').slice(0, MOST).map(originOf),
    color: /^[#\w\s(),.%/-]{1,60}$/.exec(given.get('color') ?? '')?.[0] ?? null,
    flags: given.getAll('flag').filter(isShort).slice(0, MOST),
  };
}

function settingsIn(given: URLSearchParams, page: PageData): HostSettings {
  const text = (name: string): string => given.get(name) ?? '';
  const isDark = flagOf(given.get('dark_mode'));
  const device = text('board') || text('device');
  return defined({
    language: languageOf(text('lang')),
    theme:
      THEMES.find((one) => one === text('theme')) ?? (isDark === undefined ? undefined : isDark ? 'dark' : 'light'),
    speed: SPEEDS.find((one) => String(one) === text('speed')),
    muted: flagOf(given.get('muted')),
    parts: partsIn(given, page['parts']),
    device: [deviceCalled(device) ?? device].find(isDevice),
    robot: [text('robot')].find(isRobotChoice),
    seed: [numberOf(text('seed'))].find(isSeed),
    reality: [numberOf(text('reality'))].find((share) => share >= 0 && share <= 1),
  });
}

/** The parts shown: those of `show`, else of `layout`, else of the page; `undefined`: all, as the pupil has chosen. */
function partsIn(given: URLSearchParams, ofPage: string | undefined): readonly Part[] | undefined {
  const isBare = flagOf(given.get('hide_topbar')) ?? false;
  const isFull = flagOf(given.get('full_screen')) ?? false;
  const asked =
    partsOf(given.getAll('show').join()) ??
    partsOfLayout(given.get('layout')) ??
    (isFull ? PICTURE : partsOf(ofPage ?? ''));
  return isBare || isFull ? (asked ?? PARTS).filter((part) => part !== 'bar') : asked;
}

/** Reads a list such as `board,arena`, or `all`; `undefined`: it names no part. */
function partsOf(list: string): readonly Part[] | undefined {
  const names: readonly string[] = isShort(list) ? list.split(/[\s,]+/) : [];
  const parts = names.includes('all') ? PARTS : PARTS.filter((part) => names.includes(part));
  return parts.length === 0 ? undefined : parts;
}

const DIALECTS = ['microbit', 'webtigerpython', 'none'] as const;

/**
 * The first known dialect among the names, `null` for `none`; without any it is WebTigerPython's, so that pages made
 * for it find what they wait for.
 */
function dialectOf(...names: readonly (string | null | undefined)[]): HostWish['dialect'] {
  const [first = 'webtigerpython'] = names.flatMap((name) => DIALECTS.filter((one) => one === name));
  return first === 'none' ? null : first;
}

const numberOf = (text: string): number => (text.trim() === '' ? NaN : Number(text));

const isShort = (text: string): boolean => text.length <= LONGEST;

/** The origin of an address; anything else stays as it is, and matches no page. */
function originOf(text: string): string {
  const url = urlOf(text);
  return url?.protocol === 'https:' || url?.protocol === 'http:' ? url.origin : text;
}

/** An address in its parts; `null` if it is not an address. */
export function urlOf(text: string, base?: string): URL | null {
  try {
    return new URL(text, base);
  } catch {
    return null;
  }
}

/** The settings without those that are `undefined`: any other one is held, whatever its value. */
function defined<T extends object>(settings: T): { [Name in keyof T]?: Exclude<T[Name], undefined> } {
  const given = Object.entries(settings).filter(([, value]) => value !== undefined);
  return Object.fromEntries(given) as { [Name in keyof T]?: Exclude<T[Name], undefined> };
}
