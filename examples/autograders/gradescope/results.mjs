// node results.mjs result.json: one hand-in of `parcours check --json` as Gradescope's results.json.
import { readFileSync } from 'node:fs';

const { handIns } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const [{ passed, points, stars, checks, worlds, remarks }] = handIns;
const isUnread = worlds.length === 0;
const status = (good) => (good ? 'passed' : 'failed');
const starsText = stars === undefined ? '' : ` ${'★'.repeat(stars)}${'☆'.repeat(3 - stars)}`;

const results = {
  score: points,
  output: isUnread ? remarks[0] : `${passed ? 'Passed.' : 'Not passed yet.'}${starsText}`,
  output_format: 'text',
  stdout_visibility: 'hidden',
  tests: [
    ...checks.map((check) => ({
      name: check.id,
      status: status(check.passed),
      score: check.passed ? check.points : 0,
      max_score: check.points,
      output: check.reason ?? '',
      visibility: 'visible',
    })),
    // Hidden worlds and remarks are for the teacher.
    ...worlds.map((world) => ({
      name: `World: ${world.id}`,
      status: status(world.passed),
      output: world.reason ?? '',
      visibility: world.hidden ? 'hidden' : 'visible',
    })),
    ...(remarks.length > 0 ? [{ name: 'Remarks', output: remarks.join('\n'), visibility: 'hidden' }] : []),
  ],
};
console.log(JSON.stringify(results, null, 2));
