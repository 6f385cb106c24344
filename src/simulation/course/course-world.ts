import type { Pose, Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { BRIGHTEST_LEVEL, unpackLevels } from '#scene/background';
import { carriedPose, carriersOf } from '#scene/kinds/stuck-tags';
import { isZone } from '#scene/kinds/zone';
import type { Outline } from '#scene/outline';
import type { Background, Point, Scene, SceneObject, Tag, Zone } from '#scene/scene';
import { ownOutline } from '#scene/shape/shape';
import type { BlockHandle, FloorGrid, MoverHandle } from '#world/shapes';
import { ROOM_LX } from '#world/light/light';
import { createWorld, type World } from '#world/world';
import { movableIds } from '../at-once';
import { bodyOf, type Body } from './bodies';
import { isLasting, isMovable } from '../kinds';
import type { Switchable } from '../switching/switches';
import { outlineAt } from '../task/outline-at';

/** A world made from a course; it follows changes of the course during a run. */
export class CourseWorld {
  readonly world: World;
  /** The course with which the run began. */
  readonly began: Scene;
  private now: Scene;
  private readonly blocks = new Map<string, BlockHandle>();
  private readonly movers = new Map<string, MoverHandle>();
  /** The bodies that follow the course, by id, each with the object that it shows. */
  private readonly following = new Map<string, { readonly object: SceneObject; readonly body: Body }>();
  private background: Background | null = null;
  private zones: ReadonlyMap<string, Zone>;

  /** The things that are switched now, by object id: another map whenever it has changed. */
  switched: ReadonlyMap<string, Switchable> = new Map();

  /** Builds everything in the course, object by object in its order. */
  constructor(course: Scene) {
    this.began = course;
    this.now = course;
    this.zones = zonesIn(course);
    this.world = createWorld({ widthMm: course.size[0], heightMm: course.size[1] });
    if (course.ambient !== undefined) this.world.light.setRoom(course.ambient);
    for (const object of course.objects) this.add(object);
    this.showBackground(course.background);
  }

  /** The course as it is now. */
  get course(): Scene {
    return this.now;
  }

  /** A movable block of the run. */
  block(id: string): BlockHandle | undefined {
    return this.blocks.get(id);
  }

  /** The outline of a movable block where it lies, in world mm; `null`: a robot holds it, or there is none of this id. */
  lying(id: string): Outline | null {
    const [handle, shape] = [this.blocks.get(id), this.now.objects.find((object) => object.id === id)];
    if (handle === undefined || handle.isHeld() || shape?.type !== 'block') return null;
    return outlineAt(ownOutline(shape), handle.pose());
  }

  /** Ids of the movable blocks of the run. */
  movableIds(): ReadonlySet<string> {
    return new Set(this.blocks.keys());
  }

  /** Poses of the movable blocks, by object id. */
  blockPoses(): Record<string, Pose> {
    return posesOf(this.blocks);
  }

  /** Poses of the moving obstacles, by object id. */
  moverPoses(): Record<string, Pose> {
    return posesOf(this.movers);
  }

  /**
   * Applies the changes that show at once (see `at-once.ts`). Everything else is left alone: a pushed block stays where
   * it is.
   */
  take(course: Scene): void {
    if (course.ambient !== this.now.ambient) this.world.light.setRoom(course.ambient ?? ROOM_LX);
    this.now = course;
    this.zones = zonesIn(course);
    const movable = movableIds(this.movableIds(), this.began, course);
    const kept = new Set(movable);
    for (const [layer, object] of course.objects.entries()) {
      if (isLasting(object) || (isMovable(object) && !movable.has(object.id))) continue;
      kept.add(object.id);
      this.bring(object);
      this.following.get(object.id)?.body.setLayer?.(layer);
    }
    for (const [id, { body }] of this.following) {
      if (kept.has(id)) continue;
      body.remove?.();
      this.following.delete(id);
      this.blocks.delete(id);
      this.setSwitched(id, undefined);
    }
    this.showBackground(course.background);
  }

  /** Makes the world show an object: adds its body, or changes or replaces the present one. */
  private bring(object: SceneObject): void {
    const shown = this.following.get(object.id);
    if (shown && isSame(shown.object, object)) return;
    if (shown?.object.type === object.type && shown.body.follow?.(object)) {
      this.following.set(object.id, { object, body: shown.body });
      return;
    }
    shown?.body.remove?.();
    if (shown?.object.type !== object.type) this.following.delete(object.id);
    this.add(object);
  }

  private add(object: SceneObject): void {
    const body = bodyOf(object, this.world, {
      zone: (id) => this.zones.get(id),
      carried: (tag) => this.carried(tag),
    });
    if (body && !isLasting(object)) this.following.set(object.id, { object, body });
    if (body?.block) this.blocks.set(object.id, body.block);
    else this.blocks.delete(object.id);
    if (body?.mover) this.movers.set(object.id, body.mover);
    this.setSwitched(object.id, body?.switched);
  }

  private carried({ id }: Tag): Pose | null {
    const carrier = carriersOf(this.now.objects).get(id);
    const thing = carrier && (this.blocks.get(carrier.id) ?? this.movers.get(carrier.id));
    return carrier && thing ? carriedPose(carrier, thing.pose()) : null;
  }

  private setSwitched(id: string, switched: Switchable | undefined): void {
    if (!switched && !this.switched.has(id)) return;
    const others = [...this.switched].filter(([other]) => other !== id);
    this.switched = new Map(switched ? [...others, [id, switched]] : others);
  }

  private showBackground(background: Background | null): void {
    if (isSame(background, this.background)) return;
    this.background = background;
    this.world.setFloor(background && gridOf(background));
  }
}

const zonesIn = ({ objects }: Scene): ReadonlyMap<string, Zone> =>
  new Map(objects.filter(isZone).map((zone) => [zone.id, zone]));

const posesOf = (handles: ReadonlyMap<string, { pose(): Pose }>): Record<string, Pose> =>
  Object.fromEntries(Array.from(handles, ([id, handle]) => [id, handle.pose()]));

const vec = ([x, y]: Point): Vec => ({ x, y });

/** The grid that the sensors see of a background; `null` if its levels are damaged, with which no run begins. */
function gridOf(background: Background): FloorGrid | null {
  const levels = unpackLevels(background);
  if (levels === null) return null;
  const [columns, rows] = background.cells;
  const reflectances = Float32Array.from(levels, (level) => level / BRIGHTEST_LEVEL);
  return { atMm: vec(background.at), sizeMm: vec(background.size), columns, rows, reflectances };
}
