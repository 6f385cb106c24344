import { boardTypes } from '#board/boards/index';
import { robotTypes } from '#robots/index';

/** Column where the descriptions of options begin. */
const MARGIN = ' '.repeat(22);

const robotNames = [...robotTypes.map(({ id }) => id), 'or none for the microcomputer alone'].join(`,\n${MARGIN}`);
const boardNames = boardTypes.map(({ id }) => id).join(' or ');

/** The text of `parcours --help`. */
export const help = `Parcours runs a micro:bit program with a simulated robot, without a window.

  npx parcours run MAIN.py [options]
  npx parcours run PROJECT.json|HEX.hex|LINK [options]
  npx parcours check TASK HAND-INS… [--jobs N] [--report REPORT.html] [--junit R.xml]
                     [--csv R.csv] [--json] [--lang NAME] [--shard I/N] [--resume DIR]
  npx parcours check --merge DIR [--report …] [--junit …] [--csv …] [--json]
  npx parcours replay RUN.json [--at TIME | --line FILE:LINE [--hit N]] [--device NAME] [--json]
  npx parcours convert IN [--out PATH] [--as FORM] [--json]
  npx parcours convert IN --as hex --firmware FILE.hex [--board NAME] [--file DRIVER.py]
                       [--out PATH]
  npx parcours probe compare BOARD.csv [OTHER.csv]

A project or a link brings its program, course, robot and settings; options win over them.

The program drives exactly as in the browser, only as fast as this computer can. What it
prints appears here. Two runs with the same files, options and seed are the same.

Which course, which robot
  --scene COURSE      the course: its file, a project or a link that has one, the id of a ready one
                      such as closed-line; without it: an empty arena of 1200 x 900 mm,
                      the robot in its centre, heading to the right
  --robot NAME        ${robotNames}
                      (default: the course's, else by what the program imports)
  --board NAME        ${boardNames}
                      (default: the course's, else by what the program imports)
  --option ID=CHOICE  something about the robot, for instance what hangs on a servo port: S1=claw;
                      may be given several times; an unknown one lists those there are
  --firmware NAME     for the micro:bit v2.1.2 (default) or newest, with the names that came later
  --file DRIVER.py    puts a further file on the board, for instance a module that
                      MAIN.py imports; may be given several times
  --device NAME=PROGRAM.py[,robot=ID|none][,board=ID][,file=DRIVER.py]
                      a further microcomputer in the same arena, with a robot or without, which
                      hears the others by radio; up to seven. Its robot stands at the
                      course's next start, or beside the first. A project or a link in the place
                      of PROGRAM.py gives its first device.
                      What is printed has the name of its device before each line

How long, and what happens
  --for TIME          run for this long, for example 500ms, 20s or 2min, to the µs unless the
                      program is inside a call that has begun; the world goes on when the
                      program ends (default: until the program ends, at most 10 minutes of
                      simulated time)
  --until-verdict     run until the task of the course is decided, or nothing more can happen;
                      exit code 0 if it is passed, 3 if it is not
  --input FILE.json   buttons, sensors, typed text, the hand and changes of the course, each
                      at its time:
                      [ { "at": "1s", "button": "a", "down": true },
                        { "at": "2s", "serial": "hello\\r\\n" },
                        { "at": "3s", "sensor": "lightLevel", "value": 10 },
                        { "at": "4s", "radio": "go" },
                        { "at": "4s", "device": "remote", "button": "b", "down": true },
                        { "at": "5s", "place": { "xMm": 300, "yMm": 200, "headingDeg": 90 } },
                        { "at": "6s", "edit": { "type": "remove", "ids": ["stroke-1"] } } ]
                      what is typed after the program's end goes to the REPL
  --seed NUMBER       where chance begins (default 1): random numbers repeat with it
  --reality NUMBER    from 0, the ideal robot (default), to 1, one like the used robots of a
                      school: unequal motors, weak battery, trembling sensors; from the seed
  --senses on|off     whether compass, accelerometer, light and microphone feel the arena: a
                      program alone does (on), a project as it was saved; what --input sets stays

  --my-robot FILE     a project with a measured robot ("My robot" on the page): it drives as that
                      one does

What you get
  --json              at the end one line with everything about the run, for other programs;
                      "verdict" tells whether the task of the course is passed, "devices" what
                      became of each device
  --strict            refuses to run what the real board would not understand, and says why
  --lang NAME         the language in which errors are explained: de, fr, it or en (default)
  --log FILE.csv      the board's data log, for a spreadsheet
  --trace FILE.csv    where the robot was every 20 ms, for a spreadsheet; with several devices
                      the last column names the device
  --record RUN.json   the whole run, to be run again, checked and looked into with replay
  --quiet             neither the program's output nor progress

  --help, --version

check: runs hand-ins against a task, and says who has passed. TASK is a task file, a project or a
course, a link, the id of a ready course such as closed-line, or a task of a series by its number
or id: series.json#3, "LINK#3". HAND-INS are programs, project files, links, texts with links in
them (.txt, .eml), folders and zips: there each file is a hand-in with its name, each sub-folder
one whose program is main.py. What cannot be read is told and the rest goes on. Course, robot and
chance are the task's; only the programs are the pupils'. A run may take as long as the task or the
course says, else 300 simulated seconds.
  --jobs N            so many threads (default: as many as this computer has)
  --report, --csv, --junit
                      a page with drawings to print, a table for programs, test results
  --table FILE.csv    a table for a spreadsheet in the language of --lang
  --take NAME=FILE    which of several files is the program of a hand-in; may be given several times
  --json              one line at the end for other programs, the same for the same work
  --lang NAME         the language of reports and reasons
  --shard 2/7         the second of seven parts; auto: the part of this job of Slurm, Kubernetes
                      (auto/7), GitLab, CircleCI or Buildkite
  --resume DIR        keeps each result in DIR, and runs only what is missing there
  --merge DIR         runs nothing: joins what is in DIR
Exit code: 0 all have passed; 3 some have not; 2 something is wrong with the command.

replay: runs a recorded run again and compares way, output, memory and time with the recording.
With --at 3.2s, or with --line main.py:14 --hit 3, it stops there instead and shows line, call
stack, variables and robot, with --json as one line; --device names one of several devices.
Exit code: 0 the same run, or the moment; 1 another run, or the line does not come so often;
2 no recording.

convert: turns one form of work into another, or says what it is. IN is a program (.py), a project
or a course, a hex of a micro:bit or Calliope mini, a link of Parcours or of WebTigerPython (also
in a file), a course file of WebTigerPython, the id of a ready course. What cannot be taken over
is told.
  --out PATH          where it goes (default: here); .json: a project, .py: a program, .hex: a hex,
                      folder/: all its files
  --as FORM           what it shall be: project, course, program, files, hex, link or webtigerpython
                      (a link for it)
  --firmware FILE.hex for a hex: any hex of MicroPython for the board, cleaned of its files;
                      several, or a universal one, give a universal hex
  --board NAME        for a hex: microbit-v1, microbit-v2, calliope-mini-1 or calliope-mini-3 alone
  --file DRIVER.py    for a hex: a further file on the board; may be given several times
  --json              one line: kind, program, robot, board, scene and notes
Exit code: 0 done; 2 it is none of these, or cannot be had in that form,
such as a hex that has too little room: then the missing bytes are told.

probe compare: what a real board printed under the programs of docs/hardware/probe, beside
what the simulated one prints, or beside another board's; exit code 1 when rows differ.

Exit code: 0 the program finished, or its time was over; 1 it ended with an error;
2 something is wrong with the command or a file.

Examples
  npx parcours run line.py --scene courses/closed-line/scene.json --for 60s
  npx parcours run main.py --file my_driver.py --for 20s --trace way.csv
  npx parcours run main.py --record run.json
  npx parcours replay run.json --line main.py:14 --hit 3
  npx parcours convert "https://webtigerpython.ethz.ch/#?code=…" --out anna.json
  npx parcours convert main.py --as hex --firmware my-board.hex --out main.hex
  npx parcours check closed-line class.zip --report report.html --lang de
`;
