// node points.mjs result.json: one hand-in of `parcours check --json`, as GitHub Classroom's reporter takes it.
import { readFileSync } from 'node:fs';

const { maxPoints, handIns } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const [{ passed, points, checks, remarks }] = handIns;
// What cannot be read has no points: the reporter is told nothing, and the job fails and says why.
if (points === null || handIns.length > 1) {
  const names = handIns.map(({ name }) => name).join(', ');
  console.error(
    handIns.length > 1
      ? `Which of these is the program? ${names}. Hand in only that one, or call it main.py.`
      : remarks[0],
  );
  process.exit(1);
}

const result = {
  version: 1,
  status: passed ? 'pass' : 'fail',
  max_score: maxPoints,
  tests: checks.map((check) => ({
    name: check.id,
    status: check.passed ? 'pass' : 'fail',
    message: check.reason ?? '',
    score: check.passed ? check.points : 0,
    test_code: 'parcours check',
    filename: '',
    line_no: 0,
    execution_time: 0,
  })),
};
console.log(Buffer.from(JSON.stringify(result)).toString('base64'));
