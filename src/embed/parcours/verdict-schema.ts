import * as v from 'valibot';

import { pointKinds } from '#rescue-line/points';
import { leagueRules } from '#scene/league/league';
import { helps } from '#scene/scene';

const { pipe, description } = v;
const REASONS = ['time', 'forbidden', 'spikes', 'touched', 'robot', 'left'] as const;

const by = pipe(
  v.nullable(v.string()),
  description('Id of the object, or name of the device whose robot was touched; `null` for the edge or nothing.'),
);
const place = pipe(
  v.nullable(v.strictObject({ xMm: v.number(), yMm: v.number() })),
  description('Where the robot was when it was decided.'),
);
const checkpoints = v.strictObject({ passed: v.number(), of: v.number() });
const targets = v.strictObject({ reached: v.number(), of: v.number() });
const touches = pipe(v.number(), description('Number of touches of walls, blocks, the edge or obstacles.'));

const robot = v.strictObject({
  device: pipe(v.string(), description('Name of its device.')),
  state: pipe(
    v.picklist(['open', 'passed', 'failed']),
    description('`passed`: it has arrived, has won, or was not caught.'),
  ),
  atMs: pipe(v.nullable(v.number()), description('Time at which it was decided.')),
  reason: pipe(
    v.nullable(v.picklist([...REASONS, 'caught', 'beaten'])),
    description('As above. `caught`: the first robot has touched it. `beaten`: another one was first.'),
  ),
  by,
  place,
  checkpoints,
  targets,
  touches,
});

const points = v.strictObject({
  rules: v.picklist(leagueRules),
  score: pipe(v.number(), description('All points so far.')),
  lines: pipe(
    v.array(
      v.strictObject({
        what: v.picklist(pointKinds),
        tile: pipe(v.number(), description('Number of the tile that it belongs to, from 0 on.')),
        count: pipe(v.number(), description('Number of gaps, tiles, …')),
        points: pipe(v.number(), description('The points that it has brought; still open: those that it brings now.')),
        state: pipe(v.picklist(['earned', 'open', 'missed']), description('`missed`: its section was passed over.')),
      }),
    ),
    description('What there is to earn, along the way.'),
  ),
  factor: v.exactOptional(pipe(v.number(), description('The factor for victims; left out: 1.'))),
  lacks: pipe(v.number(), description('Number of lacks of progress.')),
  section: pipe(v.number(), description('The section that the robot is in, from 1 on.')),
  attempt: pipe(v.number(), description('Its try at this section, from 1 on.')),
  tile: pipe(v.number(), description('Number of the tile that it has reached, from 0 on.')),
});

/** The schema of a verdict: how well the task of the course is done. */
export const verdictSchema = pipe(
  v.nullable(
    v.strictObject({
      state: pipe(
        v.picklist(['open', 'passed', 'failed', 'helped']),
        description('All but `open` are final. `helped`: done, but with help that the task does not allow; it does not count as passed.'), // prettier-ignore
      ),
      atMs: pipe(v.nullable(v.number()), description('Time of the decision.')),
      reason: pipe(
        v.nullable(v.picklist(REASONS)),
        description('Why it failed. `robot`: another robot was touched. `left`: nobody is in the ring any more.'),
      ),
      by,
      place,
      help: pipe(
        v.array(v.picklist(helps)),
        description('Help until the decision: `hand` moved the robot or a block, `edits` changed the course.'),
      ),
      early: pipe(
        v.nullable(v.strictObject({ id: v.string(), number: v.number(), before: v.number() })),
        description('A place that the robot came to before its turn: its id, its number (0: a target), and the number of the checkpoint that is next.'), // prettier-ignore
      ),
      checkpoints,
      targets,
      blocks: v.strictObject({ delivered: v.number(), of: v.number() }),
      stars: pipe(
        v.nullable(v.number()),
        description('1 to 3 for who has passed, otherwise 0; `null` for a task that gives no stars.'),
      ),
      touches,
      robots: pipe(
        v.array(robot),
        description('How it stands for each robot, where the task is one for several; else empty.'),
      ),
      points: v.exactOptional(
        pipe(points, description('Points of a line that is scored by the rules of a league; left out: it is not.')),
      ),
    }),
  ),
  description('How well the task of the course is done; `null` if the course has no task.'),
);
