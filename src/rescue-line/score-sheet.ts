import type { League, LeagueTile } from '#scene/league/league';
import type { PointLine, Points } from './points';
import { pointRules, type PointRules } from './rules';

/** A section of the way: from a checkpoint (or the start) to the next one, or to the end. */
export interface Section {
  /** Number of the tile at which a robot begins. */
  readonly from: number;
  /** Number of the tile at which it ends: a checkpoint, or the last. */
  readonly to: number;
}

/** The sections of a way. */
export function sectionsOf(tiles: readonly LeagueTile[]): readonly Section[] {
  const marks = tiles.flatMap(({ checkpoint }, index) => (checkpoint && index > 0 ? [index] : []));
  const last = tiles.length - 1;
  const ends = marks.at(-1) === last ? marks : [...marks, last];
  return ends.map((to, index) => ({ from: index === 0 ? 0 : (ends[index - 1] ?? 0), to }));
}

/** How far a run has come, for the score sheet. */
export interface Progress {
  /** Numbers of the tiles whose gaps, crossings and obstacles it has passed. */
  readonly passed: ReadonlySet<number>;
  /** Number of sections that are over. */
  readonly over: number;
  /** Number of lacks of progress by section. */
  readonly lacks: readonly number[];
  /** Numbers of sections that were passed over. */
  readonly missed: ReadonlySet<number>;
  /** It has stood on the last tile long enough, or all victims are in safety where the line ends in their zone. */
  readonly isDone: boolean;
  /** It has come into the zone where the line ends: the tiles up to there count. */
  readonly isInLastZone?: boolean;
  readonly tile: number;
  /** Victims in their safe places, and those that were moved. */
  readonly victims: Victims;
  /** The section with the evacuation zone. */
  readonly zoneSection: number;
}

/** The number of victims that were brought to safety, and how many there are. */
export interface Victims {
  readonly living: number;
  readonly dead: number;
  /** Out of their discs, but not in safety. */
  readonly moved: number;
  readonly of: { readonly living: number; readonly dead: number };
}

export const NO_VICTIMS: Victims = { living: 0, dead: 0, moved: 0, of: { living: 0, dead: 0 } };

/** The points of a run that has come so far. */
export function pointsOf(league: League, progress: Progress): Points {
  const rules = pointRules[league.rules];
  const sections = sectionsOf(league.tiles);
  const lines = [...linesOnWay(league, sections, rules, progress), ...victimLines(rules, progress)];
  const sum = lines.reduce((so, { state, points }) => (state === 'earned' ? so + points : so), 0);
  const factor = factorOf(rules, progress);
  const section = Math.min(progress.over, sections.length - 1);
  return {
    rules: league.rules,
    score: Math.round(sum * factor),
    lines,
    ...(factor === 1 ? {} : { factor }),
    lacks: progress.lacks.reduce((so, count) => so + count, 0),
    section: section + 1,
    attempt: (progress.lacks[section] ?? 0) + 1,
    tile: progress.tile,
  };
}

function linesOnWay(
  { tiles }: League,
  sections: readonly Section[],
  rules: PointRules,
  progress: Progress,
): readonly PointLine[] {
  // prettier-ignore
  const lines: PointLine[] = [];
  const put = (what: PointLine['what'], tile: number, count: number, points: number, state: PointLine['state']): void => {
    if (points > 0 || state !== 'open' || what === 'tiles') lines.push({ what, tile, count, points, state });
  }; // prettier-ignore
  if (rules.start > 0) put('start', 0, 1, rules.start, 'earned');
  for (const [number, { from, to }] of sections.entries()) {
    const isMissed = progress.missed.has(number);
    const rest = isMissed ? 'missed' : 'open';
    for (let index = from; index < to; index++) {
      const { gaps = 0, crossings = 0, obstacles = 0 } = tiles[index] ?? {};
      const state = progress.passed.has(index) ? 'earned' : rest;
      if (gaps > 0) put('gap', index, gaps, gaps * rules.gap, state);
      if (crossings > 0 && rules.crossing > 0) put('crossing', index, crossings, crossings * rules.crossing, state);
      if (obstacles > 0) put('obstacle', index, obstacles, obstacles * rules.obstacle, state);
    }
    const isLast = number === sections.length - 1;
    const count = to - from;
    const isOver = isLast ? progress.isDone || progress.isInLastZone === true : progress.over > number;
    const each = rules.tile[progress.lacks[number] ?? 0] ?? 0;
    put('tiles', to, count, isMissed ? 0 : count * each, isMissed ? 'missed' : isOver ? 'earned' : 'open');
  }
  if (rules.exit > 0) {
    const lacks = progress.lacks.reduce((so, count) => so + count, 0);
    const points = Math.max(0, rules.exit - rules.exitLack * lacks);
    put('exit', tiles.length - 1, 1, points, progress.isDone ? 'earned' : 'open');
  }
  return lines;
}

/** Points for each victim, where the rules give such. */
function victimLines({ victims: rules }: PointRules, { victims, tile }: Progress): readonly PointLine[] {
  const all = victims.of.living + victims.of.dead;
  if (all === 0) return [];
  if (rules.kind === 'factor') {
    const line = (what: 'living' | 'dead', done: number, of: number): readonly PointLine[] =>
      of === 0 ? [] : [{ what, tile, count: done, points: 0, state: done === of ? 'earned' : 'open' }];
    return [...line('living', victims.living, victims.of.living), ...line('dead', victims.dead, victims.of.dead)];
  }
  const rescued = victims.living + victims.dead;
  const count = rescued + victims.moved;
  const line = (what: 'moved' | 'rescued', done: number, each: number): PointLine => ({
    ...{ what, tile, count: done },
    ...(done > 0 ? { points: done * each, state: 'earned' } : { points: all * each, state: 'open' }),
  });
  return [line('moved', count, rules.out), line('rescued', rescued, rules.rescue)];
}

/** The product of the factors of all victims in safety; dead ones count once all living ones are there. */
function factorOf({ victims: rules }: PointRules, { victims, lacks, zoneSection }: Progress): number {
  if (rules.kind !== 'factor') return 1;
  const { living, dead, of } = victims;
  const count = living + (living === of.living ? dead : 0);
  const each = Math.max(rules.least, rules.factor - rules.lack * (lacks[zoneSection] ?? 0));
  return Array.from({ length: count }).reduce<number>((product) => product * each, 1);
}

/** The points of a run that has not begun. */
export const pointsAtStart = (league: League): Points =>
  pointsOf(league, {
    ...{ passed: new Set<number>(), missed: new Set<number>(), lacks: [], over: 0, tile: 0 },
    ...{ isDone: false, victims: NO_VICTIMS, zoneSection: 0 },
  });
