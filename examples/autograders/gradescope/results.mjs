// node results.mjs result.json: one hand-in of `parcours check --json` as Gradescope's results.json.
import { readFileSync } from 'node:fs';

const { handIns } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const [{ passed, points, stars, checks, worlds, remarks }] = handIns;
// Several: it is not known which of them is meant.
const isUnread = points === null || handIns.length > 1;
const names = handIns.map(({ name }) => name).join(', ');
const whyUnread =
  handIns.length > 1
    ? `Which of these is the program? ${names}. Hand in only that one, or call it main.py.`
    : remarks[0];
const status = (good) => (good ? 'passed' : 'failed');
const starsText = stars === undefined ? '' : ` ${'★'.repeat(stars)}${'☆'.repeat(3 - stars)}`;

const results = {
  // What cannot be read has no score, and is not graded with 0.
  ...(!isUnread && { score: points }),
  output: isUnread ? whyUnread : `${passed ? 'Passed.' : 'Not passed yet.'}${starsText}`,
  output_format: 'text',
  stdout_visibility: 'hidden',
  tests: [
    ...checks.map((check) => ({
      name: check.id,
      status: status(check.passed && !isUnread),
      ...(!isUnread && { score: check.passed ? check.points : 0 }),
      max_score: check.points,
      output: check.reason ?? '',
      visibility: 'visible',
    })),
    // Hidden worlds and remarks are for the teacher.
    ...(isUnread ? [] : worlds).map((world) => ({
      name: `World: ${world.id}`,
      status: status(world.passed),
      output: world.reason ?? '',
      visibility: world.hidden ? 'hidden' : 'visible',
    })),
    ...(remarks.length > 0 ? [{ name: 'Remarks', output: remarks.join('\n'), visibility: 'hidden' }] : []),
  ],
};
console.log(JSON.stringify(results, null, 2));
