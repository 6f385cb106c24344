/**
 * Fits the motor law of each robot that has a src/robots/<id>/motor-law.mjs and writes docs/hardware/<id>-motor-law.md.
 *
 *     node scripts/fit-motor-law.mjs            fits them all, writes the pages, prints how far off each one is
 *     node scripts/fit-motor-law.mjs --check    exits with 1 when a page is not what this script writes
 *
 * The law, for a wheel with duty D = byte / 255 while the wheels' mean speed is V (see src/world/drive-law.ts):
 *
 *     v = v0 · (D − dry(v) ∓ m) / (D + viscous)        outer wheel minus, inner wheel plus, never below 0
 *     dry(v) = coulomb + share · (1 − v / (until · v0))   the second term never below 0
 *     m = yawResistance · (V / v0)³ · Δ / √(Δ² + (0.1 · V)²)   Δ the wheels' difference, which it never reverses
 *
 * It is fitted to two things at once: how fast the robot drives straight at a power byte, and how wide the circles are
 * for which the drivers' own `leftArc(radius)` was tuned on real robots.
 */
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';

const ROBOTS = new URL('../src/robots/', import.meta.url);
const PAGES = new URL('../docs/hardware/', import.meta.url);

/** Circles that count: radius in m, speed in percent. The other circles in the tables hardly weigh. */
const RADII = [0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5];
const SHOWN_RADII = [0.1, ...RADII, 1];
const SPEEDS = [30, 50, 70, 100];

/** Straight speeds may be off by this factor, up or down, before it costs (a robot may say otherwise): published ones differ by 1.7. */
const STRAIGHT_TOLERANCE = 1.22;

/*
 * Weights. The worst circle counts most, as a pupil sees at once when a circle has the wrong size; the mean of all comes
 * next, so that the others do not drift up to the worst one. The numbers were tried until neither spoils the other.
 */
const ALL_CIRCLES_WEIGHT = 0.1;
const OTHER_CIRCLES_WEIGHT = 0.005;
const STRAIGHT_WEIGHT = 0.02;
const BEYOND_TOLERANCE_WEIGHT = 3;
/** Wheels that should stand still: cost per share of the stall force that is missing. */
const STANDING_WEIGHT = 100;
/** No more breakaway friction than standing still and the circles ask for. */
const SPARING_WEIGHT = 0.05;
/**
 * How steeply the pull must fall with speed at the duty that just moves a wheel, as a share of the stall force at v0: with
 * less a wheel at low power takes more than half a second to reach its speed, and circles begin as spirals.
 */
const LEAST_DAMPING = 0.08;
/** The lowest end of the breakaway friction, as a share of v0: below a creep it makes no difference. */
const LEAST_UNTIL = 0.05;

/** Share of the mean speed; src/world/drive-law.ts says what it is. */
const SCRUB_FULL_BEYOND = 0.1;

const NAMES = ['v0', 'coulomb', 'viscous', 'share', 'until', 'yawResistance'];
const lawOf = (numbers) => Object.fromEntries(NAMES.map((name, i) => [name, numbers[i]]));

/** Speed a wheel settles at, in mm/s, with `moment` for or against it. */
function wheelSpeed({ v0, coulomb, viscous, share, until }, byte, moment) {
  const duty = byte / 255;
  const pull = duty - coulomb + moment;
  const fast = pull / (duty + viscous);
  if (fast >= until) return v0 * fast;
  return Math.max(0, (v0 * (pull - share)) / (duty + viscous - share / until));
}

/** Speeds [inner, outer] in mm/s once they no longer change. */
function steadySpeeds(law, innerByte, outerByte) {
  const speedsAt = (moment) => [wheelSpeed(law, innerByte, moment), wheelSpeed(law, outerByte, -moment)];
  const moment = bisect(0, outerByte / 255, (tried) => {
    const [inner, outer] = speedsAt(tried);
    return outer > inner && scrub(law, inner, outer) > tried;
  });
  return speedsAt(moment);
}

function scrub({ v0, yawResistance }, inner, outer) {
  const mean = (inner + outer) / 2;
  return yawResistance * (mean / v0) ** 3 * ((outer - inner) / Math.hypot(outer - inner, SCRUB_FULL_BEYOND * mean));
}

/** The place between `low` and `high` where `isBelow` turns from true to false. */
function bisect(low, high, isBelow) {
  for (let i = 0; i < 40; i++) {
    const middle = (low + high) / 2;
    if (isBelow(middle)) low = middle;
    else high = middle;
  }
  return low;
}

/** Radius driven, in mm. */
function circleMm(law, { motorLaw, arcBytes }, radiusM, percent) {
  const [inner, outer] = steadySpeeds(law, ...arcBytes(radiusM, percent));
  return ((motorLaw.trackMm / 2) * (outer + inner)) / Math.max(outer - inner, 1e-9);
}

/** How much wider the circle is than requested: 0.1 = 10 %. */
const circleError = (law, robot, radiusM, percent) => circleMm(law, robot, radiusM, percent) / (1000 * radiusM) - 1;
/** Logarithm of the factor by which the robot is too fast. */
const straightError = (law, [byte, speed]) => Math.log(Math.max(wheelSpeed(law, byte, 0), 1) / speed);

const toleranceOf = ({ motorLaw }) => motorLaw.straight.tolerance ?? STRAIGHT_TOLERANCE;

function costOf(robot, numbers) {
  const law = lawOf(numbers);
  if (numbers.some((value) => !(value > 0)) || law.until < LEAST_UNTIL) return Infinity;
  let worst = 0;
  let sum = 0;
  for (const percent of SPEEDS) {
    for (const radius of SHOWN_RADII) {
      const error = circleError(law, robot, radius, percent);
      const counts = RADII.includes(radius);
      if (counts) worst = Math.max(worst, Math.abs(error));
      sum += (counts ? ALL_CIRCLES_WEIGHT : OTHER_CIRCLES_WEIGHT) * Math.min(error * error, 1);
    }
  }
  for (const row of robot.motorLaw.straight.rows) {
    const error = straightError(law, row);
    sum += STRAIGHT_WEIGHT * error * error;
    sum += BEYOND_TOLERANCE_WEIGHT * Math.max(0, Math.abs(error) - Math.log(toleranceOf(robot)));
  }
  const least = law.coulomb + law.share;
  sum += STANDING_WEIGHT * Math.max(0, robot.motorLaw.standsAt / 255 - least);
  sum += STANDING_WEIGHT * Math.max(0, LEAST_DAMPING - (least + law.viscous - law.share / law.until));
  return worst + sum + SPARING_WEIGHT * law.share;
}

/** Nelder and Mead's downhill simplex, restarted until it stands still: deterministic, no derivatives needed. */
function minimise(f, start) {
  let best = start;
  for (let restart = 0; restart < 40; restart++) {
    const next = descend(f, best, restart % 3 === 2 ? 1.4 : 1.1);
    if (restart > 4 && f(best) - f(next) < 1e-6) return next;
    best = next;
  }
  return best;
}

function descend(f, start, stretch) {
  const point = (x) => ({ x, y: f(x) });
  const mix = (a, b, t) => point(a.map((value, i) => value + t * (b[i] - value)));
  const stretched = start.map((_, i) => start.map((value, j) => (i === j ? value * stretch : value)));
  let corners = [start, ...stretched].map(point);
  for (let round = 0; round < 300; round++) {
    corners.sort((a, b) => a.y - b.y);
    const worst = corners[corners.length - 1];
    const others = corners.slice(0, -1);
    const middle = start.map((_, i) => others.reduce((sum, corner) => sum + corner.x[i], 0) / others.length);
    const reflected = mix(middle, worst.x, -1);
    const tried = reflected.y < corners[0].y ? mix(middle, worst.x, -2) : mix(middle, worst.x, 0.5);
    const better = reflected.y < tried.y ? reflected : tried;
    if (better.y < worst.y) corners = [...others, better];
    else corners = corners.map((corner) => mix(corners[0].x, corner.x, 0.5));
  }
  corners.sort((a, b) => a.y - b.y);
  return corners[0].x;
}

/** The constants as the robot's type and its page have them. */
function fit(robot) {
  const numbers = minimise((tried) => costOf(robot, tried), robot.motorLaw.start);
  return lawOf(numbers.map((value, i) => (i === 0 ? Math.round(value) : Math.round(value * 1e4) / 1e4)));
}

const percentOf = (error) => {
  const percent = Math.round(error * 100);
  return `${percent > 0 ? '+' : percent < 0 ? '−' : ''}${Math.abs(percent)} %`;
};

/** The arcs for which the driver sends the same bytes, and how near one circle can come to all of them. */
function sharedBytes({ arcBytes }) {
  return SPEEDS.flatMap((percent) => {
    const byBytes = new Map();
    for (const radius of RADII) {
      const bytes = arcBytes(radius, percent).join('/');
      byBytes.set(bytes, [...(byBytes.get(bytes) ?? []), radius]);
    }
    return [...byBytes].filter(([, radii]) => radii.length > 1).map(([bytes, radii]) => ({ percent, bytes, radii }));
  });
}

function sharedText(robot) {
  const rows = sharedBytes(robot).map(({ percent, bytes, radii }) => {
    const [low, high] = [radii[0], radii.at(-1)];
    return `| ${percent} | ${bytes} | ${radii.join(', ')} | ±${Math.round((100 * (high - low)) / (high + low))} % |`;
  });
  if (rows.length === 0) return 'The driver sends different bytes for each of these radii.';
  return `For some radii the driver sends the same bytes. One circle must then do for all of them; the best that any law can reach:

| speed | bytes | radii in m | best possible |
|---|---|---|---|
${rows.join('\n')}`;
}

function worstText(robot, law) {
  const cells = SPEEDS.flatMap((percent) =>
    RADII.map((radius) => ({ percent, radius, error: circleError(law, robot, radius, percent) })),
  );
  const worst = Math.max(...cells.map(({ error }) => Math.abs(error)));
  const mean = Math.sqrt(cells.reduce((sum, { error }) => sum + error * error, 0) / cells.length);
  const beyond = cells.filter(({ error }) => Math.abs(error) > 0.25);
  const list = beyond.map(({ percent, radius, error }) => `r = ${radius} at speed ${percent} (${percentOf(error)})`);
  return `From ${RADII[0]} to ${RADII.at(-1)} m at these speeds the worst circle is ${(worst * 100).toFixed(1)} % off, all of them ${(mean * 100).toFixed(1)} % (root mean square).
More than 25 % off: ${list.join(', ') || 'none'}.`;
}

const circleCell = (robot, law, radius, percent) => {
  const bytes = robot.arcBytes(radius, percent).join('/');
  const cm = circleMm(law, robot, radius, percent) / 10;
  return `${cm.toFixed(1)} (${percentOf(circleError(law, robot, radius, percent))}) · ${bytes}`;
};

function page(robot, law) {
  const { motorLaw } = robot;
  const straightRows = motorLaw.straight.rows.map((row) => {
    const speed = wheelSpeed(law, row[0], 0).toFixed(0);
    return `| ${row[0]} | ${row[1]} | ${speed} | ${percentOf(Math.exp(straightError(law, row)) - 1)} |`;
  });
  const circleRows = SHOWN_RADII.map(
    (radius) => `| ${radius} | ${SPEEDS.map((percent) => circleCell(robot, law, radius, percent)).join(' | ')} |`,
  );
  return `# Motor law of the ${motorLaw.name}

*Written by \`node scripts/fit-motor-law.mjs\` from \`src/robots/${robot.id}/motor-law.mjs\`; do not edit. \`src/robots/arcs.test.ts\`
checks that the robot uses these constants and drives these circles.*

With duty D = byte / 255 and V the mean speed of the wheels, a wheel settles at

    v = v0 · (D − dry(v) ∓ m) / (D + viscous)
    dry(v) = coulomb + share · (1 − v / (until · v0)), the second term never below 0
    m = yawResistance · (V / v0)³ · Δ / √(Δ² + (${SCRUB_FULL_BEYOND} · V)²), Δ the difference of the wheels

outer wheel minus, inner wheel plus. A direct-current motor driven by pulses pulls less the faster it turns (v0), loses
some of its pull to dry friction (coulomb), more of it while it starts up (share, until), and some to friction that grows
with speed (viscous); in curves the scrub of tyres and castor holds the outer wheel back and pushes the inner one
(yawResistance). In the world the same law acts as forces (\`src/world/drive-law.ts\`), so pushing, stalling and walls change
the speeds as they should. Why it looks like that: [decision 0013](../decisions/0013-a-motor-law-for-all-robots.md).

| constant | value |
|---|---|
| v0 | ${law.v0} mm/s |
| coulomb | ${law.coulomb} |
| viscous | ${law.viscous} |
| breakaway share | ${law.share} |
| breakaway until | ${law.until} |
| yawResistance | ${law.yawResistance} |
| track | ${motorLaw.trackMm} mm (given, not fitted) |

A wheel starts at power byte ${Math.ceil((law.coulomb + law.share) * 255)}. Fitted so that the worst circle from ${RADII[0]} to ${RADII.at(-1)} m at speeds ${SPEEDS.join(', ')} is as good as can be, then their
mean square, with every straight speed within ${Math.round((toleranceOf(robot) - 1) * 100)} % where possible.

## Straight ahead

${motorLaw.straight.source}

| power byte | source mm/s | law mm/s | deviation |
|---|---|---|---|
${straightRows.join('\n')}

## Circles

What \`leftArc(radius)\` and \`rightArc(radius)\` drive. The driver (${motorLaw.driver}) was tuned on real
robots, so the radius asked for is the measurement. Each cell: radius driven in cm (deviation) · power bytes inner/outer.

| radius in m | ${SPEEDS.map((percent) => `speed ${percent}`).join(' | ')} |
|---|${SPEEDS.map(() => '---').join('|')}|
${circleRows.join('\n')}

${[worstText(robot, law), ...motorLaw.notes, sharedText(robot)].join('\n\n')}
`;
}

async function robotsWithLaw() {
  const ids = readdirSync(ROBOTS).filter((id) => existsSync(new URL(`${id}/motor-law.mjs`, ROBOTS)));
  return Promise.all(ids.map(async (id) => ({ id, ...(await import(new URL(`${id}/motor-law.mjs`, ROBOTS).href)) })));
}

const isCheck = process.argv.includes('--check');
for (const robot of await robotsWithLaw()) {
  const law = fit(robot);
  const text = page(robot, law);
  const file = new URL(`${robot.id}-motor-law.md`, PAGES);
  if (!isCheck) {
    writeFileSync(file, text);
    console.log(`${robot.motorLaw.name}: ${JSON.stringify(law)}\n${worstText(robot, law)}\n`);
  } else if (!existsSync(file) || readFileSync(file, 'utf8') !== text) {
    console.error(`docs/hardware/${robot.id}-motor-law.md is out of date. Run: node scripts/fit-motor-law.mjs`);
    process.exitCode = 1;
  }
}
