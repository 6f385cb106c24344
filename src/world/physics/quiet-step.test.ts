import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { STEP_S } from '../step';
import { testChassis } from '../testing/rig';
import { PlanckWorld, PolygonShape, Vec2 } from './planck';
import { quietStep } from './quiet-step';
import { RobotBody } from './robot-body';
import { toUnits } from './scale';
import { createSurroundings } from './surroundings';

const [VELOCITY_ROUNDS, POSITION_ROUNDS] = [12, 4];
const [STEPS, WALL_MM] = [3000, 250];

/** A robot beside a wall, in a world that is moved on by hand. */
function beside(step: (world: PlanckWorld) => void) {
  const world = new PlanckWorld({ gravity: new Vec2(0, 0), allowSleep: true, continuousPhysics: false });
  const [floor, walls] = [world.createBody(), world.createBody()];
  const corners = [
    { x: WALL_MM, y: -2000 },
    { x: WALL_MM + 50, y: -2000 },
    { x: WALL_MM + 50, y: 2000 },
    { x: WALL_MM, y: 2000 },
  ];
  walls.createFixture({ shape: new PolygonShape(corners.map(toUnits)), friction: 0.3 });
  const around = createSurroundings(world, new Map());
  const robot = new RobotBody(world, floor, around, testChassis(), { xMm: 0, yMm: 0, headingRad: 0.1 });
  return () => {
    robot.beforeStep();
    step(world);
    robot.afterStep();
    return { robot, awake: world.getBodyList()?.isAwake(), contacts: world.getContactCount() };
  };
}

describe('a quiet step', () => {
  it('is the engine’s own to the last bit: while a robot drives, brakes, sleeps and comes near a wall', () => {
    const rng = createRng(7);
    let quiet = 0;
    const alone = beside((world) => {
      if (quietStep(world, VELOCITY_ROUNDS)) quiet++;
      else world.step(STEP_S, VELOCITY_ROUNDS, POSITION_ROUNDS);
    });
    const engine = beside((world) => world.step(STEP_S, VELOCITY_ROUNDS, POSITION_ROUNDS));
    let near = 0;
    for (let n = 0; n < STEPS; n++) {
      const [one, other] = [alone(), engine()];
      expect(Object.values(one.robot.pose())).toEqual(Object.values(other.robot.pose()));
      expect([one.awake, one.contacts]).toEqual([other.awake, other.contacts]);
      near += one.contacts > 0 ? 1 : 0;
      if (n % 50 !== 0) continue;
      // Standing for more than half a second lets it sleep.
      const duties = n % 500 < 200 ? [0, 0] : [rng.unit() * 2 - 0.8, rng.unit() * 2 - 0.8];
      for (const { robot } of [one, other]) duties.forEach((duty, wheel) => robot.setDuty(wheel === 0 ? 0 : 1, duty));
    }
    expect([quiet > STEPS / 4, quiet < STEPS, near > 0]).toEqual([true, true, true]);
  });
});
