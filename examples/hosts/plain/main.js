import 'parcours-element';

const at = (id) => document.getElementById(id);
const simulator = at('simulator');
// Where Parcours is: beside this page, unless its own address says otherwise.
simulator.src = new URLSearchParams(location.search).get('parcours') ?? './parcours/';

const PHASES = { ready: 'Ready', starting: 'Starting …', running: 'Running', paused: 'Paused', stopping: 'Stopping …' };
const ENDS = { finished: 'The program has ended', exception: 'An error: see below', stopped: 'Stopped' };
const VERDICTS = { open: '', passed: 'Well done: the block is in the field.', failed: 'Not this time. Start again.' };

const tell = (text) => (at('state').textContent = text);
const show = (phase) => tell(PHASES[phase] ?? 'Stopped');
const judge = (verdict) => (at('verdict').textContent = VERDICTS[verdict?.state ?? 'open']);

/** A command of a button; why it is refused is shown. */
const command = (id, act) =>
  at(id).addEventListener('click', () => act().catch((error) => tell(error.message ?? String(error))));

command('run', () => simulator.run());
command('stop', () => simulator.stop());
command('reset', () => simulator.reset());

simulator.addEventListener('parcours-ready', async () => {
  for (const id of ['run', 'stop', 'reset']) at(id).disabled = false;
  show((await simulator.getState()).phase);
});
simulator.addEventListener('parcours-error', ({ detail }) => tell(detail.message));
simulator.addEventListener('phase', ({ detail }) => show(detail.phase));
simulator.addEventListener('started', () => {
  at('console').textContent = '';
  judge(null);
});
simulator.addEventListener('output', ({ detail }) => at('console').append(detail.text));
simulator.addEventListener('snapshot', ({ detail }) => judge(detail.snapshot.verdict));
simulator.addEventListener('ended', ({ detail }) => {
  tell(ENDS[detail.ended] ?? 'The microcomputer has stopped');
  judge(detail.verdict);
});
