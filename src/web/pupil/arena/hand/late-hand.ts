import type { Pose } from '#core/geometry';
import type { PlacedPose } from '#simulation/input';
import type { View } from '../view/view-transform';
import type { Hand, HandPorts } from './hand';
import type { HandMarks } from './hand-marks';
import type * as Parts from './hand-parts';
import type { HeldThing } from './held-thing';
import type { RobotShape } from './hit-test';

/** Everything the hand reads and changes. */
export interface LateHandPorts extends Omit<HandPorts, 'place'> {
  readonly place: (thing: HeldThing, pose: PlacedPose) => void;
}

type Told = 'pointerDown' | 'pointerMove' | 'pointerUp' | 'pointerLeave' | 'keyDown' | 'keyUp' | 'focus';

/** The hand, which is loaded when the arena is first touched: until then it holds nothing and notes what it is told. */
export interface LateHand extends Pick<Hand, Told | 'held' | 'cursor' | 'poseOf' | 'wheel' | 'tick' | 'release'> {
  /** The marks in the picture; `null`: none shows. */
  marks(view: View, robot: RobotShape | null, heldPose: Pose | null): HandMarks | null;
}

/** Most that is noted: more than a minute of drawing. Later news are dropped. */
const MOST = 10_000;

/** The keys that move the robot. */
const MOVES = /^(Arrow(Up|Down|Left|Right)|[qe])$/;

type Load = () => Promise<typeof Parts>;

/** @param load loads the hand */
export function createLateHand(ports: LateHandPorts, load: Load = () => import('./hand-parts')): LateHand {
  let parts: typeof Parts | null = null;
  let hand: Hand | null = null;
  const early: ((hand: Hand) => unknown)[] = [];
  let isLoading = false;

  async function fetch(): Promise<void> {
    if (isLoading) return;
    isLoading = true;
    const loaded = await load().catch(() => null); // no connection at the moment: loaded with the next touch
    isLoading = false;
    const noted = early.splice(0);
    if (loaded === null) return;
    const place: HandPorts['place'] = (thing, pose) => ports.place(thing, loaded.placedPose(pose));
    parts = loaded;
    hand = new loaded.Hand({ ...ports, place });
    for (const tell of noted) tell(hand);
    ports.changed();
  }
  /** Tells the hand, or notes it until the hand is there. */
  function begin(tell: (hand: Hand) => unknown): void {
    if (hand !== null) return void tell(hand);
    if (early.length < MOST) early.push(tell);
    void fetch();
  }
  /** The same, of what means nothing to a hand that was told nothing before. */
  function goOn(tell: (hand: Hand) => unknown): void {
    if (hand !== null || early.length > 0) begin(tell);
  }
  return {
    get held() {
      return hand?.held ?? null;
    },
    get cursor() {
      return hand?.cursor ?? 'default';
    },
    poseOf: (thing, pose) => hand?.poseOf(thing, pose) ?? pose,
    marks: (view, robot, heldPose) => (hand && parts?.handMarks(hand, view, robot, heldPose)) ?? null,
    pointerDown: (press) => begin((it) => it.pointerDown(press)),
    pointerMove: (id, at, keepsHeading) => begin((it) => it.pointerMove(id, at, keepsHeading)),
    pointerUp: (id) => goOn((it) => it.pointerUp(id)),
    pointerLeave: () => goOn((it) => it.pointerLeave()),
    keyDown(key, fine) {
      if (hand !== null) return hand.keyDown(key, fine);
      const isUsed = MOVES.test(key) ? ports.robot() !== null : key === 'Escape' && early.length > 0;
      if (isUsed) begin((it) => it.keyDown(key, fine));
      return isUsed;
    },
    keyUp: () => goOn((it) => it.keyUp()),
    focus: (focused) => (focused ? begin : goOn)((it) => it.focus(focused)),
    wheel: (deltaPx) => hand?.wheel(deltaPx) ?? false,
    tick: () => hand?.tick(),
    release() {
      early.length = 0;
      hand?.release();
    },
  };
}
