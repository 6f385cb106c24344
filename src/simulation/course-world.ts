import type { Pose, Vec } from '#core/geometry';
import { BRIGHTEST_LEVEL, unpackLevels } from '#scene/background';
import { reflectanceOf } from '#scene/reflectance';
import type { Background, Block, Point, Scene, Stroke } from '#scene/scene';
import { createWorld, type BlockHandle, type FloorGrid, type MoverHandle } from '#world/world';
import type { StrokeHandle, World } from '#world/world';
import { isEqual, isLasting, movableIds, type LastingObject } from './at-once';

/** A thing in the world, and the object of the course that it shows. */
interface Shown<T, Handle> {
  readonly object: T;
  readonly handle: Handle;
}

/** A world made from a course; it follows changes of the course during a run. */
export class CourseWorld {
  readonly world: World;
  private readonly began: Scene;
  private readonly blockById = new Map<string, Shown<Block, BlockHandle>>();
  private readonly moverById = new Map<string, MoverHandle>();
  private readonly strokeById = new Map<string, Shown<Stroke, StrokeHandle>>();
  private background: Background | null = null;

  /** Builds everything in the course, object by object in its order. */
  constructor(course: Scene) {
    this.began = course;
    this.world = createWorld({ widthMm: course.size[0], heightMm: course.size[1] });
    for (const object of course.objects) {
      if (isLasting(object)) this.addLasting(object);
      else if (object.type === 'block') this.addBlock(object);
      else if (object.type === 'stroke') this.addStroke(object);
    }
    this.showBackground(course.background);
  }

  /** A movable block of the run. */
  block(id: string): BlockHandle | undefined {
    return this.blockById.get(id)?.handle;
  }

  /** Ids of the movable blocks of the run. */
  movableIds(): ReadonlySet<string> {
    return new Set(this.blockById.keys());
  }

  /** Poses of the movable blocks, by object id. */
  blockPoses(): Record<string, Pose> {
    return Object.fromEntries(Array.from(this.blockById, ([id, { handle }]) => [id, handle.pose()]));
  }

  /** Poses of the moving obstacles, by object id. */
  moverPoses(): Record<string, Pose> {
    return Object.fromEntries(Array.from(this.moverById, ([id, mover]) => [id, mover.pose()]));
  }

  /**
   * Applies the changes that show at once (see `at-once.ts`). Everything else is left alone: a pushed block stays where
   * it is.
   */
  take(course: Scene): void {
    this.takeBlocks(course);
    this.takeStrokes(course);
    this.showBackground(course.background);
  }

  private takeBlocks(course: Scene): void {
    const wanted = movableIds(new Set(this.blockById.keys()), this.began, course);
    for (const object of course.objects) {
      if (object.type !== 'block' || !wanted.has(object.id)) continue;
      const shown = this.blockById.get(object.id);
      if (shown !== undefined && isEqual(shown.object, object)) continue;
      if (shown !== undefined && isEqual(shown.object.size, object.size)) {
        shown.handle.place(poseOf(object));
        this.blockById.set(object.id, { object, handle: shown.handle });
      } else {
        if (shown !== undefined) this.world.removeBlock(shown.handle);
        this.addBlock(object);
      }
    }
    for (const [id, { handle }] of this.blockById) {
      if (wanted.has(id)) continue;
      this.world.removeBlock(handle);
      this.blockById.delete(id);
    }
  }

  private takeStrokes({ objects }: Scene): void {
    const ids = new Set<string>();
    for (const [layer, object] of objects.entries()) {
      if (object.type !== 'stroke') continue;
      ids.add(object.id);
      const shown = this.strokeById.get(object.id);
      if (shown === undefined || (shown.object !== object && !isEqual(shown.object, object))) {
        shown?.handle.remove();
        this.addStroke(object);
      }
      this.strokeById.get(object.id)?.handle.setLayer(layer);
    }
    for (const [id, { handle }] of this.strokeById) {
      if (ids.has(id)) continue;
      handle.remove();
      this.strokeById.delete(id);
    }
  }

  private showBackground(background: Background | null): void {
    if (isEqual(background, this.background)) return;
    this.background = background;
    this.world.setFloor(background && gridOf(background));
  }

  private addLasting(object: LastingObject): void {
    const { id } = object;
    switch (object.type) {
      case 'wall':
        this.world.addWall({ id, fromMm: vec(object.from), toMm: vec(object.to), thicknessMm: object.thickness });
        return;
      case 'fixed-block':
      case 'spikes':
        this.world.addBlock({ id, ...boxOf(object), fixed: true });
        return;
      case 'mover':
        this.moverById.set(
          id,
          this.world.addMover({ id, ...boxOf(object), toMm: vec(object.to), speedMmPerS: object.speed }),
        );
        return;
      default:
        object satisfies never;
    }
  }

  private addBlock(object: Block): void {
    const handle = this.world.addBlock({ id: object.id, ...boxOf(object), fixed: false });
    this.blockById.set(object.id, { object, handle });
  }

  private addStroke(object: Stroke): void {
    const handle = this.world.addStroke({
      pointsMm: object.points.map(vec),
      widthMm: object.width,
      reflectance: reflectanceOf[object.color],
    });
    this.strokeById.set(object.id, { object, handle });
  }
}

interface Box {
  readonly at: Point;
  readonly size: Point;
  readonly turn: number;
}

const vec = ([x, y]: Point): Vec => ({ x, y });

const angleOf = ({ turn }: Box): number => (turn * Math.PI) / 4;

const boxOf = (box: Box): { readonly atMm: Vec; readonly sizeMm: Vec; readonly angleRad: number } => ({
  atMm: vec(box.at),
  sizeMm: vec(box.size),
  angleRad: angleOf(box),
});

const poseOf = (box: Box): Pose => ({ xMm: box.at[0], yMm: box.at[1], headingRad: angleOf(box) });

/** A background for the sensors; `null` if its levels are damaged (no run begins with such a background). */
function gridOf(background: Background): FloorGrid | null {
  const levels = unpackLevels(background);
  if (levels === null) return null;
  const [columns, rows] = background.cells;
  const reflectances = Float32Array.from(levels, (level) => level / BRIGHTEST_LEVEL);
  return { atMm: vec(background.at), sizeMm: vec(background.size), columns, rows, reflectances };
}
