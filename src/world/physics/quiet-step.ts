import { STEP_S } from '../step';
import { Settings } from './planck';
import type { PlanckWorld, TimeStep } from './planck';
import type { Point, SolverBody } from './solver-body';

interface QuietJoint {
  initVelocityConstraints(step: TimeStep): void;
  solveVelocityConstraints(step: TimeStep): void;
}

interface Edge {
  readonly joint: QuietJoint;
  readonly other: QuietBody;
  readonly next: Edge | null;
}

/** Further properties of a body. */
interface QuietBody extends SolverBody {
  readonly m_next: QuietBody | null;
  readonly m_jointList: Edge | null;
  readonly m_contactList: object | null;
  readonly m_linearVelocity: Point;
  m_angularVelocity: number;
  m_sleepTime: number;
  isAwake(): boolean;
  isStatic(): boolean;
  isDynamic(): boolean;
  setAwake(isAwake: boolean): void;
  synchronizeTransform(): void;
  synchronizeFixtures(): void;
}

interface ListedContact {
  readonly m_filterFlag: boolean;
  readonly m_next: ListedContact | null;
}

/** Properties of a world. */
interface QuietWorld {
  readonly m_newFixture: boolean;
  readonly m_bodyList: QuietBody | null;
  readonly m_contactList: ListedContact | null;
  readonly m_broadPhase: { readonly m_moveBuffer: readonly unknown[] };
  readonly s_step: TimeStep & { reset(dt: number): void };
  findNewContacts(): void;
}

/** The limits of a step, as the engine has them. */
const { maxTranslation, maxRotation, timeToSleep } = Settings;
const SLOW = Settings.linearSleepTolerance * Settings.linearSleepTolerance;
const SLOW_TURN = Settings.angularSleepTolerance * Settings.angularSleepTolerance;

/**
 * Moves a world on in which nothing that is awake comes near anything else: each body on its own, with the engine's
 * arithmetic in the engine's order, and without its search for what belongs together. So a run is the same to the last bit.
 *
 * @param rounds of the solver
 * @returns false if the world is not so quiet; then nothing has happened, and the engine has to do it
 */
export function quietStep(planckWorld: PlanckWorld, rounds: number): boolean {
  const world = planckWorld as unknown as QuietWorld;
  const awake = aloneIn(world);
  if (awake === null) return false;
  world.s_step.reset(STEP_S);
  for (const body of awake) move(body, world.s_step, rounds);
  for (const body of awake) body.synchronizeFixtures();
  if (world.m_broadPhase.m_moveBuffer.length > 0) world.findNewContacts();
  return true;
}

/** The moving bodies, if each has joints to the floor alone and touches nothing; else `null`. */
function aloneIn(world: QuietWorld): readonly QuietBody[] | null {
  if (world.m_newFixture) return null;
  const awake: QuietBody[] = [];
  for (let body = world.m_bodyList; body; body = body.m_next) {
    if (body.isStatic() || !body.isAwake()) continue;
    if (!body.isDynamic() || body.m_contactList) return null;
    for (let edge = body.m_jointList; edge; edge = edge.next) if (!edge.other.isStatic()) return null;
    awake.push(body);
  }
  for (let contact = world.m_contactList; contact; contact = contact.m_next) if (contact.m_filterFlag) return null;
  return awake;
}

function move(body: QuietBody, step: TimeStep, rounds: number): void {
  const { m_sweep: sweep, c_position: position, c_velocity: velocity, m_linearVelocity: speed } = body;
  copy(sweep.c0, sweep.c);
  sweep.a0 = sweep.a;
  copy(position.c, sweep.c);
  position.a = sweep.a;
  // No force and no damping: the engine adds 0, which makes a 0 of −0.
  velocity.v.x = speed.x + 0;
  velocity.v.y = speed.y + 0;
  velocity.w = body.m_angularVelocity + 0;
  solve(body, step, rounds);
  integrate(body);
  copy(sweep.c, position.c);
  sweep.a = position.a;
  copy(speed, velocity.v);
  body.m_angularVelocity = velocity.w;
  body.synchronizeTransform();
  restIfSlow(body);
}

function solve({ m_jointList: first }: QuietBody, step: TimeStep, rounds: number): void {
  for (let edge = first; edge; edge = edge.next) edge.joint.initVelocityConstraints(step);
  for (let round = 0; round < rounds; round++)
    for (let edge = first; edge; edge = edge.next) edge.joint.solveVelocityConstraints(step);
}

function integrate({ c_position: position, c_velocity: velocity }: QuietBody): void {
  const { v } = velocity;
  const [x, y] = [STEP_S * v.x, STEP_S * v.y];
  const squared = x * x + y * y;
  if (squared > maxTranslation * maxTranslation) {
    const ratio = maxTranslation / Math.sqrt(squared);
    v.x *= ratio;
    v.y *= ratio;
  }
  const turn = STEP_S * velocity.w;
  if (turn * turn > maxRotation * maxRotation) velocity.w *= maxRotation / Math.abs(turn);
  position.c.x += STEP_S * v.x;
  position.c.y += STEP_S * v.y;
  position.a += STEP_S * velocity.w;
}

/** Lets a body sleep that has been slow for long enough. */
function restIfSlow(body: QuietBody): void {
  const { m_angularVelocity: turn, m_linearVelocity: speed } = body;
  const isSlow = turn * turn <= SLOW_TURN && speed.x * speed.x + speed.y * speed.y <= SLOW;
  body.m_sleepTime = isSlow ? body.m_sleepTime + STEP_S : 0;
  if (isSlow && body.m_sleepTime >= timeToSleep) body.setAwake(false);
}

const copy = (to: Point, from: Point): void => {
  to.x = from.x;
  to.y = from.y;
};
