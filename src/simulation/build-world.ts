import { createWorld, type BlockHandle, type World } from '#world/world';
import type { Vec } from '#core/geometry';
import type { Point, Scene, SceneObject, StrokeColor } from '#scene/scene';

/** A world made from a course, and its movable blocks by object id. */
export interface BuiltWorld {
  readonly world: World;
  readonly blocks: ReadonlyMap<string, BlockHandle>;
}

/** Diffuse reflectance of a stroke relative to the floor. Chosen: black paint 0, white as the floor, gray half-way. */
const reflectanceOf: Readonly<Record<StrokeColor, number>> = { black: 0, gray: 0.5, white: 1 };

/** Builds what a course describes, object by object in the order of the file. */
export function buildWorld(scene: Scene): BuiltWorld {
  const world = createWorld({ widthMm: scene.size[0], heightMm: scene.size[1] });
  const blocks = new Map<string, BlockHandle>();
  for (const object of scene.objects) addObject(world, blocks, object);
  return { world, blocks };
}

function addObject(world: World, blocks: Map<string, BlockHandle>, object: SceneObject): void {
  switch (object.type) {
    case 'wall':
      world.addWall({ fromMm: vec(object.from), toMm: vec(object.to), thicknessMm: object.thickness });
      return;
    case 'block':
    case 'fixed-block': {
      const fixed = object.type === 'fixed-block';
      const angleRad = (object.turn * Math.PI) / 4;
      const handle = world.addBlock({ atMm: vec(object.at), sizeMm: vec(object.size), angleRad, fixed });
      if (!fixed) blocks.set(object.id, handle);
      return;
    }
    case 'stroke':
      world.addStroke({
        pointsMm: object.points.map(vec),
        widthMm: object.width,
        reflectance: reflectanceOf[object.color],
      });
      return;
    default:
      object satisfies never;
  }
}

const vec = ([x, y]: Point): Vec => ({ x, y });
