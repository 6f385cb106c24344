// Looks at a web server from outside, as a browser sees it: types, compression, headers, and whether each file is whole.
// The page check.html runs it; the tests run it in Node. It uses nothing but `fetch`.

/** The types in which files must come, by their endings. */
const TYPES = {
  css: ['text/css'],
  html: ['text/html'],
  js: ['text/javascript', 'application/javascript'],
  json: ['application/json'],
  png: ['image/png'],
  svg: ['image/svg+xml'],
  wasm: ['application/wasm'],
  webmanifest: ['application/manifest+json', 'application/json'],
};
/** These become much smaller when they are compressed. */
const COMPRESSIBLE = /\.(css|html|js|svg|wasm)$/;
/** Smaller ones need not be, in bytes. */
const SMALL = 20_000;
/** Files named by their content: they never change. */
const FOR_EVER = /^assets\/.*-[\w-]{6,8}\.\w+$/;
const DAY_S = 86_400;
/** Files asked for at the same time: as many as a browser asks one server for. */
const AT_ONCE = 6;
/** Files that a finding names. */
const NAMED = 5;

const endingOf = (file) => file.slice(file.lastIndexOf('.') + 1);
const typeOf = (headers) => (headers.get('content-type') ?? '').split(';')[0].trim().toLowerCase();
const longestS = (headers) => Number(/(?:^|[\s,])max-age=(\d+)/.exec(headers.get('cache-control') ?? '')?.[1] ?? NaN);
const isAsked = (headers) => /no-cache|no-store|max-age=0(?!\d)/.test(headers.get('cache-control') ?? '');

/**
 * @typedef {{ file: string, bytes: number }} Listed a file that must be there, with its length
 * @typedef {{ files: readonly Listed[], policies: { page: string, worker: string } }} List
 * @typedef {{ file: string, bytes: number, status: number, got: number, headers: Headers }} Answer
 * @typedef {{ id: string, state: 'ok' | 'warn' | 'bad', files: readonly string[] }} Finding `files`: those in which it is wrong
 */

/**
 * Asks for each file of the list, past every cache.
 *
 * @param {List} list
 * @param {(file: string) => Promise<Response>} ask
 * @param {(done: number) => void} [tell] is told how many have come
 * @returns {Promise<readonly Answer[]>}
 */
export async function askForAll({ files }, ask, tell = () => undefined) {
  const answers = [];
  const left = [...files.keys()];
  let done = 0;
  const one = async () => {
    for (let place = left.shift(); place !== undefined; place = left.shift()) {
      answers[place] = await answerTo(files[place], ask);
      done += 1;
      tell(done);
    }
  };
  await Promise.all(Array.from({ length: AT_ONCE }, one));
  return answers;
}

async function answerTo({ file, bytes }, ask) {
  try {
    const response = await ask(file);
    const got = (await response.arrayBuffer()).byteLength;
    return { file, bytes, status: response.status, got, headers: response.headers };
  } catch {
    return { file, bytes, status: 0, got: 0, headers: new Headers() };
  }
}

const isPage = ({ file }) => endingOf(file) === 'html' && !isSingle({ file });
const isSingle = ({ file }) => /\.single\.html$/.test(file);
const isWorker = ({ file }) => /^assets\/worker-.*\.js$/.test(file);
const policyOf = ({ headers }) => headers.get('content-security-policy') ?? '';
const isForEver = ({ file }) => FOR_EVER.test(file);
const isSaid = ({ headers }) => !Number.isNaN(longestS(headers)) || isAsked(headers);

/** The things that can be wrong with an answer: how bad it is, and whether it is so. */
const FAULTS = {
  length: ['bad', ({ got, bytes }) => got !== bytes],
  types: ['bad', ({ file, headers }) => TYPES[endingOf(file)]?.includes(typeOf(headers)) === false],
  compression: [
    'warn',
    (one) => COMPRESSIBLE.test(one.file) && one.bytes > SMALL && !isSingle(one) && !one.headers.get('content-encoding'),
  ],
  stale: ['bad', (one) => !isForEver(one) && longestS(one.headers) > 0],
  fresh: ['warn', (one) => !isForEver(one) && endingOf(one.file) !== 'txt' && !isSaid(one)],
  kept: ['warn', (one) => isForEver(one) && !(longestS(one.headers) >= DAY_S)],
  blocked: ['bad', (one, policies) => policyOf(one) !== '' && isBlocked(one, policies)],
  policy: [
    'warn',
    (one) => (isPage(one) && policyOf(one) === '') || (isWorker(one) && !/connect-src 'none'/.test(policyOf(one))),
  ],
  boards: ['bad', (one) => isPage(one) && /(?:usb|serial)=\(\)/.test(one.headers.get('permissions-policy') ?? '')],
};

/**
 * Judges a server by its answers. A fault that only a file that has come can have is not looked for in others.
 *
 * @param {readonly Answer[]} answers
 * @param {List['policies']} policies
 * @returns {readonly Finding[]}
 */
export function findingsIn(answers, policies) {
  const there = answers.filter(({ status }) => status === 200);
  const finding = (id, state, wrong) => ({
    id,
    state: wrong.length === 0 ? 'ok' : state,
    files: wrong.slice(0, NAMED).map(({ file }) => file),
  });
  const missing = answers.filter(({ status }) => status !== 200);
  return [
    finding('missing', 'bad', missing),
    ...Object.entries(FAULTS).map(([id, [state, is]]) =>
      finding(
        id,
        state,
        there.filter((one) => is(one, policies)),
      ),
    ),
  ];
}

/** True if the policy of an answer keeps it from working. */
function isBlocked(one, policies) {
  if (isSingle(one)) return true; // it has a stricter one of its own
  if (isPage(one)) return !allows(policyOf(one), policies.page);
  return isWorker(one) && !/'(?:wasm-)?unsafe-eval'/.test(policyOf(one));
}

/** True if a policy allows all that the page needs: each source of the directives that it has. */
function allows(policy, wanted) {
  const parts = (text) =>
    new Map(
      text
        .split(';')
        .map((part) => part.trim().split(/\s+/))
        .map(([name, ...sources]) => [name, sources]),
    );
  const given = parts(policy);
  return [...parts(wanted)].every(([name, sources]) => {
    const allowed = given.get(name) ?? (name.endsWith('-src') ? given.get('default-src') : undefined);
    // Browsers of today need one of the two words for WebAssembly.
    const needed = sources.filter((source) => source !== "'none'" && source !== "'unsafe-eval'");
    const isOne = (source) =>
      allowed.includes(source) || (source === "'wasm-unsafe-eval'" && allowed.includes("'unsafe-eval'"));
    return allowed === undefined || needed.every(isOne);
  });
}
