import { radOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { TILE_MM, type League, type LeagueTile, type RescueZone } from '#scene/league/league';
import type { Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import { linePlaces, type LinePlaces } from './line-places';
import type { Points } from './points';
import { pointRules } from './rules';
import { NO_VICTIMS, pointsOf, sectionsOf, type Section, type Victims } from './score-sheet';

/** The robot as the referee sees it. */
export interface Seen {
  readonly pose: Pose;
  /** The middle of its area, world mm. */
  readonly middle: Vec;
  /** Convex parts of its body now, world mm, none farther than `reachMm` from the middle. */
  readonly body: () => readonly Outline[];
  readonly reachMm: number;
}

/** How far a standing robot may shake. */
const STILL_MM = 1;

/** Chosen: a robot that is so far from the tiles where it should be, a whole tile, does not find the line any more. */
const LOST_MM = TILE_MM / 2 + TILE_MM;

/**
 * Follows a run over the tiles of a line and gives its points.
 *
 * - A tile is *reached* when more than half of the robot is on it and it is over the line there. What a tile holds counts
 *   when the next tile is reached, once.
 * - *Lack of progress*: the robot was on the next tile and leaves it without having found the line; or it is on the line
 *   of a tile that is not next; or it is a whole tile away. It then begins anew at the last checkpoint; after the failed
 *   tries of the rules, at the next one. An obstacle may be driven around: while there is one on this tile or the next,
 *   only being far away is a lack, and the tile behind it may be the first on which the line is found again.
 * - *Done*: it stands on the last tile for as long as the rules say; where the line ends in the evacuation zone, when it
 *   has come there and all victims are in safety.
 */
export class Referee {
  private readonly sections: readonly Section[];
  private lines: LinePlaces | null = null;
  private tile = 0;
  private over = 0;
  private lacks: readonly number[];
  private readonly passed = new Set<number>();
  private readonly missed = new Set<number>();
  /** True while the robot is on the next tile, but has not found the line there. */
  private isSearching = false;
  private isThrough = false;
  private isInLastZone = false;
  private victims: Victims = NO_VICTIMS;
  private stood: { readonly pose: Pose; readonly sinceUs: number } | null = null;
  private given: Points | null = null;

  constructor(
    private readonly league: League,
    private objects: Scene['objects'],
  ) {
    this.sections = sectionsOf(league.tiles);
    this.lacks = this.sections.map(() => 0);
  }

  /** The lines of another course are followed from now on. */
  take(objects: Scene['objects']): void {
    if (objects !== this.objects) this.lines = null;
    this.objects = objects;
  }

  get isDone(): boolean {
    return this.isThrough;
  }

  /** The points now: the same object as long as nothing has changed. */
  points(): Points {
    const { passed, over, lacks, missed, tile, victims, isInLastZone, isThrough: isDone } = this;
    return (this.given ??= pointsOf(this.league, { passed, over, lacks, missed, tile, victims, isDone, isInLastZone, zoneSection: this.zoneSection })); // prettier-ignore
  }

  /** True if the robot is in the evacuation zone, where victims are to be looked at. */
  isInZone({ x, y }: Vec): boolean {
    const { zone } = this.league;
    return zone !== undefined && holds(zone, x, y);
  }

  /** Takes note of the victims. */
  see(victims: Victims): void {
    if (isSame(victims, this.victims)) return;
    this.victims = victims;
    this.given = null;
  }

  /**
   * Looks at the robot at simulated time `timeUs`.
   *
   * @returns where it is put after a lack of progress; `null`: it drives on
   */
  look(robot: Seen, timeUs: number): Pose | null {
    if (this.isThrough) return null;
    const { x, y } = robot.middle;
    const { tiles } = this.league;
    const [here, next] = [tiles[this.tile], tiles[this.tile + 1]];
    if (next !== undefined && isOn(next, x, y)) {
      this.isSearching = !this.isOverLine(robot);
      if (!this.isSearching) this.reach(this.tile + 1);
      return null;
    }
    if (here !== undefined && isOn(here, x, y)) {
      this.isSearching = false;
      if (next === undefined && this.hasStood(robot.pose, timeUs)) this.finish();
      return null;
    }
    if (this.isBehindObstacle(robot)) {
      this.reach(this.tile + 1);
      this.reach(this.tile + 1);
      return null;
    }
    if (this.isInZone(robot.middle) && (next === undefined || next.afterZone === true)) return this.inZone(next);
    return this.isLost(robot) ? this.lack() : null;
  }

  /** Counts a lack of progress, also one that is called. @returns where the robot is put; `null`: it is done */
  lack(): Pose | null {
    if (this.isThrough) return null;
    const { failedTries } = pointRules[this.league.rules];
    this.given = null;
    this.isSearching = false;
    this.stood = null;
    this.lacks = this.lacks.map((count, section) => (section === this.over ? count + 1 : count));
    if ((this.lacks[this.over] ?? 0) >= failedTries && this.over < this.sections.length - 1) {
      this.missed.add(this.over);
      this.over += 1;
    }
    this.tile = this.sections[this.over]?.from ?? 0;
    return startOn(this.league.tiles, this.tile);
  }

  /** The section that leads into the zone. */
  private get zoneSection(): number {
    const after = this.league.tiles.findIndex(({ afterZone }) => afterZone);
    const last = after < 0 ? this.league.tiles.length - 1 : after;
    return this.sections.findIndex(({ to }) => to >= last);
  }

  private reach(tile: number): void {
    this.given = null;
    this.passed.add(this.tile);
    this.tile = tile;
    this.isSearching = false;
    this.stood = null;
    if (this.sections[this.over]?.to === tile && this.over < this.sections.length - 1) this.over += 1;
  }

  /** In the zone nothing is lost. Where the line ends, it is done when all victims are in safety. */
  private inZone(next: LeagueTile | undefined): null {
    const { living, dead, of } = this.victims;
    if (next !== undefined) return null;
    if (!this.isInLastZone) {
      this.passed.add(this.tile);
      this.isInLastZone = true;
      this.given = null;
    }
    if (of.living + of.dead > 0 && living + dead === of.living + of.dead) this.finish();
    return null;
  }

  private finish(): void {
    this.isThrough = true;
    this.over = this.sections.length;
    this.given = null;
  }

  private isLost(robot: Seen): boolean {
    const { tiles } = this.league;
    const { x, y } = robot.middle;
    const near = [tiles[this.tile], tiles[this.tile + 1]].filter((tile) => tile !== undefined);
    if (!near.some((tile) => isWithin(tile, x, y, LOST_MM))) return true;
    if (near.some(({ obstacles = 0 }) => obstacles > 0)) return false;
    if (this.isSearching) return true;
    const before = tiles[this.tile - 1];
    if (before !== undefined && isOn(before, x, y)) return false;
    return tiles.some((tile) => isOn(tile, x, y)) && this.isOverLine(robot);
  }

  /** True on the line of the tile after the next, if an obstacle on the next was driven around. */
  private isBehindObstacle(robot: Seen): boolean {
    const { tiles } = this.league;
    const [next, behind] = [tiles[this.tile + 1], tiles[this.tile + 2]];
    const { x, y } = robot.middle;
    return (next?.obstacles ?? 0) > 0 && behind !== undefined && isOn(behind, x, y) && this.isOverLine(robot);
  }

  private isOverLine(robot: Seen): boolean {
    this.lines ??= linePlaces(this.objects);
    return this.lines.isUnder(robot.body(), robot.middle, robot.reachMm);
  }

  private hasStood(pose: Pose, timeUs: number): boolean {
    const { stood } = this;
    const isStill = stood !== null && Math.abs(pose.xMm - stood.pose.xMm) + Math.abs(pose.yMm - stood.pose.yMm) < STILL_MM; // prettier-ignore
    if (stood === null || !isStill) {
      this.stood = { pose, sinceUs: timeUs };
      return false;
    }
    return timeUs - stood.sinceUs >= pointRules[this.league.rules].standSeconds * 1e6;
  }
}

const isOn = (tile: LeagueTile, x: number, y: number): boolean => isWithin(tile, x, y, TILE_MM / 2);

const isWithin = ({ at }: LeagueTile, x: number, y: number, mm: number): boolean =>
  Math.abs(x - at[0]) <= mm && Math.abs(y - at[1]) <= mm;

const holds = ({ at, size }: RescueZone, x: number, y: number): boolean =>
  Math.abs(x - at[0]) <= size[0] / 2 && Math.abs(y - at[1]) <= size[1] / 2;

/** The pose of a robot that begins on a tile: on the line, in the direction of the way. */
function startOn(tiles: readonly LeagueTile[], index: number): Pose {
  const tile = tiles[index];
  const [x, y] = tile?.at ?? [0, 0];
  const heading = tile?.heading ?? 0;
  const before = tile?.afterZone === true ? undefined : tiles[index - 1];
  const turn = before === undefined ? 0 : (heading - before.heading + 540) % 360 - 180; // prettier-ignore
  // In a bend it stands at its beginning, where the line comes in.
  const isBend = Math.abs(turn) === 90 && before !== undefined;
  const entered = isBend ? before.heading : heading;
  const back = isBend ? TILE_MM / 2 - BEND_START_MM : 0;
  const [dx, dy] = { 0: [1, 0], 90: [0, 1], 180: [-1, 0], 270: [0, -1] }[entered] ?? [0, 0];
  return { xMm: x - back * (dx ?? 0), yMm: y - back * (dy ?? 0), headingRad: radOf(entered) };
}

/** From the edge of a bend to the axle of a robot that begins there. */
const BEND_START_MM = 30;
