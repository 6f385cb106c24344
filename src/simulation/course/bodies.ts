import type { Pose, Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { rotationRad } from '#core/angle';
import { heightOf } from '#scene/kinds/heights';
import type { AnyObject } from '#scene/kinds/kind';
import { floorRgb, infraredOf, paintRgb } from '#scene/paint/reflectance';
import type { Painted } from '#scene/paint/paint';
import { zoneOverlaps } from '#scene/kinds/zone';
import { stopsOf } from '#scene/kinds/mover-way';
import { tagRimMm } from '#scene/kinds/tag-thing';
import type { Outline } from '#scene/outline';
import type {
  Barrier,
  Block,
  Chase,
  Lamp,
  Mover,
  Paper,
  Point,
  SceneObject,
  Spikes,
  Stroke,
  Tag,
  Tunnel,
  Wall,
  Zone,
} from '#scene/scene';
import { ownParts, shapeParts } from '#scene/shape/shape';
import type { BlockHandle, BodyForm, Chase as WorldChase, FieldShape, MoverHandle, Shares, Way } from '#world/shapes';
import type { World } from '#world/world';
import type { Switchable } from '../switching/switches';

/** The body of an object in a run's world. */
export interface Body {
  /** The handle of a block that can be pushed. */
  readonly block?: BlockHandle;
  /** The handle of what moves by itself. */
  readonly mover?: MoverHandle;
  /** The handle of what is switched. */
  readonly switched?: Switchable;
  /** Follows a change of its object; `false`: it has to be made anew. */
  follow?(object: SceneObject): boolean;
  /** Changes its place in the order of painting. */
  setLayer?(layer: number): void;
  /** Takes it out of the world. Only what lasts needs none. */
  remove?(): void;
}

/** Puts an object into the world of a run. */
type Build<O extends AnyObject> = (object: O, world: World, around: Around) => Body;

/** The facts about its course that an object needs during a run. */
export interface Around {
  /** The zone of this id as the course has it now. */
  readonly zone: (id: string) => Zone | undefined;
  /** The place of a tag on what carries it now; `null`: nothing does. */
  readonly carried: (tag: Tag) => Pose | null;
}

type BoxObject = Block | Spikes | Mover;

/** How each kind of object gets its body; `null`: only the verdict and people see it. */
export const builds: Readonly<Record<SceneObject['type'], Build<never> | null>> = {
  wall: wallBody,
  block: blockBody,
  'fixed-block': fixedBody,
  stroke: strokeBody,
  target: fieldBody,
  checkpoint: fieldBody,
  forbidden: fieldBody,
  paper: fieldBody,
  spikes: fixedBody,
  lamp: lampBody,
  barrier: barrierBody,
  tunnel: tunnelBody,
  tag: tagBody,
  mover: moverBody,
  label: null,
  start: null,
};

/** The body of an object in a world; `undefined`: it has none. */
export const bodyOf = (object: SceneObject, world: World, around: Around): Body | undefined =>
  builds[object.type]?.(object as never, world, around); // the table pairs each kind with its own

function wallBody(wall: Wall, world: World): Body {
  const { id, from, to, thickness } = wall;
  world.addWall({
    id,
    fromMm: vec(from),
    toMm: vec(to),
    thicknessMm: thickness,
    heightMm: heightOf(wall),
    ...sharesOf(wall),
  });
  return {};
}

function fixedBody(box: Block | Spikes, world: World): Body {
  world.addBlock({ id: box.id, ...shapeOf(box), fixed: true });
  return {};
}

function blockBody(object: Block, world: World): Body {
  const { mass, friction, rolls } = object;
  const moves = {
    ...(mass !== undefined && { massG: mass }),
    ...(friction !== undefined && { friction }),
    ...(rolls && { rolls }),
  };
  const block = world.addBlock({ id: object.id, ...shapeOf(object), ...moves, fixed: false });
  return {
    block,
    follow(now: Block) {
      const fits = isSame(formOf(now), formOf(object));
      if (fits) block.place(poseOf(now));
      return fits;
    },
    remove: () => world.removeBlock(block),
  };
}

function lampBody({ at, height, brightness, on }: Lamp, world: World): Body {
  let isOn = true;
  const lamp = world.light.addLamp({ atMm: vec(at), heightMm: height, candela: brightness, on: isOn });
  const set = (now: boolean): void => {
    isOn = now;
    lamp.switch(now);
  };
  return { switched: { switching: on ?? null, set, isOn: () => isOn }, remove: lamp.remove };
}

function barrierBody(barrier: Barrier, world: World): Body {
  const { id, from, to, thickness, opens } = barrier;
  const handle = world.addBarrier({ id, fromMm: vec(from), toMm: vec(to), thicknessMm: thickness, heightMm: heightOf(barrier) }); // prettier-ignore
  return { switched: { switching: opens, set: (isOpen) => handle.set(isOpen), isOn: () => handle.isOpen } };
}

function tunnelBody(tunnel: Tunnel, world: World): Body {
  return { remove: world.light.addTunnel(shapeParts(tunnel)) };
}

function tagBody(tag: Tag, world: World, { carried }: Around): Body {
  const { at, number, side, flat } = tag;
  const own: Pose = { xMm: at[0], yMm: at[1], headingRad: rotationRad(tag.angle) };
  const shape = { number, sideMm: side, rimMm: tagRimMm(side), isFlat: flat === true };
  return { remove: world.addTag({ ...shape, pose: () => carried(tag) ?? own }) };
}

function moverBody(object: Mover, world: World, { zone }: Around): Body {
  const { id, speed, spin = 0 } = object;
  const { atMm: _, ...shape } = shapeOf(object);
  const goes = object.chases ? chaseOf(object.at, object.chases, zone) : wayIn(object);
  const spinRadPerS = (spin * Math.PI) / 180;
  return { mover: world.addMover({ id, ...shape, speedMmPerS: speed, spinRadPerS, goes }) };
}

function wayIn(mover: Mover): Way {
  const stops = stopsOf(mover).map(({ at, wait }) => ({ atMm: vec(at), waitS: wait }));
  return { stops, loops: mover.loops ?? false, phaseS: mover.phase ?? 0 };
}

/** The chase of a mover. A guard uses its zone as it is now; if the zone is gone, it chases nobody. */
function chaseOf(at: Point, { zone: id, reach = Infinity }: Chase, zone: Around['zone']): WorldChase {
  const isIn = (name: string, body: readonly Outline[]): boolean => {
    const guarded = zone(name);
    return guarded !== undefined && body.some((part) => zoneOverlaps(guarded, part));
  };
  const wants = id === undefined ? null : (body: readonly Outline[]) => isIn(id, body);
  return { homeMm: vec(at), reachMm: reach, returns: id !== undefined, wants };
}

function strokeBody(stroke: Stroke, world: World): Body {
  const { points, width } = stroke;
  return world.addStroke({
    pointsMm: points.map(vec),
    widthMm: width,
    reflectance: infraredOf(stroke) ?? 1,
    ...sharesOf(stroke),
  });
}

function fieldBody(field: Zone | Paper, world: World): Body {
  const reflectance = infraredOf(field);
  if (reflectance === null) return {};
  return world.addField({ ...flatOf(field), reflectance, ...sharesOf(field) });
}

/** The colour of paint compared with bare floor, if there is any. */
function sharesOf({ color }: Painted): { readonly shares?: Shares } {
  if (color === undefined) return {};
  const [red, green, blue] = paintRgb[color];
  return { shares: [red / floorRgb[0], green / floorRgb[1], blue / floorRgb[2]] };
}

/** The properties of a block that a run cannot change without making it again. */
const formOf = ({ size, round, corners, height, color, mass, friction, rolls }: Block) => ({
  ...{ size, round, corners, height, color },
  ...{ mass, friction, rolls },
});

const vec = ([x, y]: Point): Vec => ({ x, y });

const angleOf = ({ angle }: Pick<BoxObject, 'angle'>): number => rotationRad(angle);

const shapeOf = (box: BoxObject): BodyForm & FlatForm => ({
  ...flatOf(box),
  heightMm: heightOf(box),
  ...('color' in box ? sharesOf(box) : {}),
});

type FlatForm = Pick<FieldShape, 'atMm' | 'sizeMm' | 'angleRad' | 'isRound' | 'partsMm'>;

const flatOf = (shape: BoxObject | Zone | Paper): FlatForm => ({
  atMm: vec(shape.at),
  sizeMm: vec(shape.size),
  angleRad: angleOf(shape),
  ...(shape.round === true ? { isRound: true } : {}),
  ...('corners' in shape ? { partsMm: ownParts(shape) } : {}),
});

const poseOf = (box: BoxObject): Pose => ({ xMm: box.at[0], yMm: box.at[1], headingRad: angleOf(box) });
