import { isSame } from '#core/same';
import type { Pose, Vec } from '#core/geometry';
import type { Points } from '#rescue-line/points';
import { Referee } from '#rescue-line/referee';
import type { League } from '#scene/league/league';
import { lengthOf, type Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import type { BlockHandle } from '#world/shapes';
import { bodyNow, type WatchedRobot } from './entrant';
import { createVictimWatch, type VictimWatch } from './victims';

/** The referee of a scored line in a run: it watches the first robot, and puts it back after a lack of progress. */
export class LineReferee {
  private readonly referee: Referee;
  private readonly victims: VictimWatch | null;
  private readonly middleMm: Vec;
  private readonly reachMm: number;

  constructor(
    private readonly league: League,
    { objects }: Pick<Scene, 'objects'>,
    private readonly robot: WatchedRobot,
    block: (id: string) => BlockHandle | undefined,
  ) {
    this.referee = new Referee(league, objects);
    this.victims = createVictimWatch(league, objects, block);
    this.middleMm = middleOf(robot.body);
    this.reachMm = robot.body.flat().reduce((far, { x, y }) => Math.max(far, lengthOf(x - this.middleMm.x, y - this.middleMm.y)), 0); // prettier-ignore
  }

  /** True once the robot has come to the end. */
  get isDone(): boolean {
    return this.referee.isDone;
  }

  /** True if a course is scored in the same way. */
  fits({ league }: Pick<Scene, 'league'>): boolean {
    return isSame(league, this.league);
  }

  /** Uses the lines of another course from now on; what was reached stays reached. */
  take({ objects }: Pick<Scene, 'objects'>): void {
    this.referee.take(objects);
  }

  points(): Points {
    return this.referee.points();
  }

  /** A lack of progress is called. */
  call(): void {
    this.put(this.referee.lack());
  }

  /** Looks at the robot at simulated time `timeUs`. */
  step(timeUs: number): void {
    const { chassis } = this.robot;
    const middle = chassis.toWorld(this.middleMm);
    if (this.victims !== null && this.referee.isInZone(middle)) this.referee.see(this.victims.count());
    const body = (): readonly Outline[] => bodyNow(this.robot);
    this.put(this.referee.look({ pose: chassis.pose(), middle, body, reachMm: this.reachMm }, timeUs));
  }

  private put(pose: Pose | null): void {
    if (pose !== null) this.robot.chassis.place(pose);
  }
}

/** The middle of the area of convex parts; where they overlap, it counts twice. */
function middleOf(parts: readonly Outline[]): Vec {
  let [area, x, y] = [0, 0, 0];
  for (const part of parts)
    for (const [index, from] of part.entries()) {
      const to = part[(index + 1) % part.length] ?? from;
      const cross = from.x * to.y - to.x * from.y;
      area += cross;
      x += (from.x + to.x) * cross;
      y += (from.y + to.y) * cross;
    }
  return area === 0 ? { x: 0, y: 0 } : { x: x / (3 * area), y: y / (3 * area) };
}
