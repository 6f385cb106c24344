import type { RobotStart, Scene, Start } from '#scene/scene';

/** The start of a further robot, the first one's place being 0; `null`: the course has none for it. */
export function furtherStart({ objects, robot: { scale } }: Scene, place: number): RobotStart | null {
  const start = startsIn(objects)[place - 1];
  return start ? { type: start.robot, at: start.at, heading: start.heading, scale, options: start.options } : null;
}

/** The starts of further robots, in their order. */
export const startsIn = (objects: Scene['objects']): readonly Start[] =>
  objects.filter((object): object is Start => object.type === 'start');
