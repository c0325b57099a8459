// Derives and interprets one drawing with the package lindenmayer; prints what it took as JSON.
// usage: node lindenmayer.js FOLDER_OF_THE_PACKAGE DRAWING

const fs = require('fs');
const LSystem = require(process.argv[2]);

const degrees = Math.PI / 180;
const drawings = {
  koch: { axiom: 'F++F++F', steps: 10, turn: 60 * degrees, productions: { F: 'F-F++F-F' } },
  tree: { axiom: 'F', steps: 9, turn: 25.7 * degrees, productions: { F: 'F[+F]F[-F]F' } },
};
const drawing = drawings[process.argv[3]];

let x = 0;
let y = 0;
let angle = Math.PI / 2;
let lines = 0;
let sum = 0;
const stack = [];
const lsystem = new LSystem({
  axiom: drawing.axiom,
  productions: drawing.productions,
  finals: {
    F: () => { lines += 1; sum += x + y; x += Math.cos(angle); y += Math.sin(angle); },
    '+': () => { angle += drawing.turn; },
    '-': () => { angle -= drawing.turn; },
    '[': () => { stack.push(x, y, angle); },
    ']': () => { angle = stack.pop(); y = stack.pop(); x = stack.pop(); },
  },
});

const before = process.cpuUsage();
lsystem.iterate(drawing.steps);
const derived = process.cpuUsage(before);
lsystem.final();
const all = process.cpuUsage(before);
const seconds = (used) => (used.user + used.system) / 1e6;
console.log(JSON.stringify({
  modules: lsystem.axiom.length, lines, sum, seconds: seconds(all), derived: seconds(derived),
  peak_kib: Number(/VmHWM:\s*(\d+)/.exec(fs.readFileSync('/proc/self/status', 'utf8'))[1]),
}));
