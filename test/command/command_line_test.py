#!/usr/bin/env python3
"""The program cable_variation, without a ROS master: command_line_test.py PROGRAM SOURCES"""
import csv
import json
import math
import os
import pty
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SOURCES = (os.path.abspath(word) for word in sys.argv[1:3])
HARNESS = os.path.join(SOURCES, 'config', 'harness.yaml')
SCENES = ('harness', 'harness_clipped', 'hose', 'rear_lamp', 'robot_assembly')
PATIENCE = 170  # [s]; the machine may be busy

OUT_OF_REACH = """
materials:
  bundle: {young_modulus: 1.0e8, poisson_ratio: 0.25, density: 2000}
cables:
  - {name: main, length: 100 mm, section: {type: solid, radius: 4 mm, material: bundle}}
clips:
  - {name: start, type: fixed, cable: main, at: start, pose: {position: [0, 0, 0]}}
  - {name: end, type: fixed, cable: main, at: end, pose: {position: [0.3, 0, 0]}}
design_variables:
  - {name: length, cable: main, property: length, tolerance: 3 mm, distribution: {type: uniform}}
measures:
  - {name: bend, type: bend_radius, cable: main, lower: 40 mm}
"""

HANGING = """
gravity: [0, 9.81, 0]
accuracy: 0.01 mm
cables:
  - name: wire   # its stiffness is a guess
    length: 1.5 m
    stiffness: {EA: 1e4 N, GA: 1e4 N, EI: 1.2e-4 N m^2, GJ: 1.2e-4 N m^2, mass_per_length: 17.4 g/m, radius: 2 mm}
    via: [[0.05, 0.3, 0], [-0.06, 0.65, 0], [-0.17, 0.3, 0]]
clips:
  - {name: a, type: fixed, cable: wire, at: start, pose: {position: [0, 0, 0]}}
  - {name: b, type: fixed, cable: wire, at: end, pose: {position: [-123 mm, 0, 0]}}
design_variables:
  - {name: EI, cable: wire, property: EI, tolerance: 50 %}
  - {name: a_rz, clip: a, rotate: z, tolerance: 20 deg}
"""

# Only the program: no master, no package path, nothing of a devel space.
ENVIRONMENT = {'PATH': '/usr/bin:/bin', 'ROS_MASTER_URI': 'http://localhost:1'}
ENVIRONMENT.update({name: value for name, value in os.environ.items()
                    if 'SAN_OPTIONS' in name or name == 'LD_LIBRARY_PATH'})


def run(*words, environment=None, **options):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=PATIENCE, check=False,
                          env={**ENVIRONMENT, **(environment or {})}, **options)


def fail_on_constant(name):
    raise ValueError(name + ' is no JSON')


def parsed(text):
    return json.loads(text, parse_constant=fail_on_constant)


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def good(self, *words):
        result = run(*words, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ''), words)
        return result.stdout

    def answer(self, *words):
        answer = parsed(self.good(*words, '--json'))
        self.assertEqual(answer['status'], {'code': 0, 'message': ''})
        return answer

    def scene(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
        return path

    def test_check_tells_what_shipped_scenes_are_made_of(self):
        for name in SCENES:
            scene = os.path.join(SOURCES, 'config', name + '.yaml')
            answer = self.answer('check', scene)
            self.assertEqual(answer['source'], scene)
            self.assertEqual(answer['warnings'], [])
            self.assertIn('no faults', self.good('check', scene))
            for cable in answer['cables']:
                box = cable['bounding_box']
                diagonal = math.dist(*[[box[end][axis] for axis in 'xyz'] for end in ('low', 'high')])
                self.assertGreater(diagonal, 0.02)
                self.assertLess(diagonal, 2 * cable['length'])
            for component in answer['components']:
                self.assertEqual('bounding_box' in component, component['triangles'] > 0)

    def test_check_tells_all_faults_and_warnings(self):
        with open(HARNESS, encoding='utf-8') as file:
            text = file.read()
        broken = self.scene('broken.yaml', text.replace('gravity:', 'gravty:') + '\nnonsense: 1\n')
        result = run('check', broken)
        self.assertEqual((result.returncode, result.stdout), (2, ''))
        self.assertIn("broken.yaml:", result.stderr)
        for word in ('gravty', 'nonsense'):
            self.assertIn(word, result.stderr)
        result = run('check', broken, '--json')
        answer = parsed(result.stdout)
        self.assertEqual((result.returncode, answer['status']['code']), (2, 1))
        self.assertGreaterEqual(len(answer['faults']), 2)
        self.assertTrue(all(fault['line'] > 0 and fault['file'] == broken for fault in answer['faults']))
        odd = self.scene('odd.yaml', re.sub(r'gravity: .*', 'gravity: [0, 0, -98.1]', text))
        result = run('check', odd, environment={'ROS_PACKAGE_PATH': SOURCES})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r'^warning: .*odd.yaml:\d+: ')

    def test_wrong_usage_is_2_and_says_what_is_meant(self):
        for words, said in (
                ((), 'no verb'),
                (('chekc',), "unknown verb 'chekc'; did you mean 'check'?"),
                (('check',), 'SCENE is missing'),
                (('check', HARNESS, HARNESS), 'unexpected'),
                (('check', HARNESS, '--reprot', 'x'), "unknown option '--reprot'"),
                (('solve', HARNESS, '--reprot', 'x'), "unknown option '--reprot'; did you mean '--report'?"),
                (('solve', HARNESS, '--report', 'x', '--report', 'y'), '--report: is given twice'),
                (('solve', HARNESS, '--report', '../x'), "file name '../x'"),
                (('solve', HARNESS, '--variables', 'wh_start_rz'), 'expected one value each'),
                (('solve', HARNESS, '--set', 'wh_start_rz'), 'expected NAME=VALUE'),
                (('solve', HARNESS, '--set', 'wh_start_rz=5mm'), 'wh_start_rz'),
                (('solve', HARNESS, '--set', 'wh_strat_rz=5deg'), "did you mean 'wh_start_rz'?"),
                (('solve', HARNESS, '--motion', 'run'), "no motion named 'run'"),
                (('simulate', HARNESS, '--samples', 'many'), '--samples: is '),
                (('simulate', HARNESS, '--sampler', 'halton'), "'halton'"),
                (('simulate', HARNESS, '--confidence', '1.5'), 'confidence: is 1.5'),
                (('envelope', HARNESS, '--probability', '2'), 'probability: is 2'),
                (('envelope', HARNESS, '--motion_only'), 'motions: is empty'),
                (('stability', HARNESS, '--measures', 'D_CARR'), "no measure named 'D_CARR'"),
                (('report', HARNESS, '--chapters', 'envelop'), "did you mean 'envelope'?"),
                (('check', os.path.join(self.folder, 'none.yaml')), 'does not exist'),
                (('check', 'package://no_such_package/x.yaml'), "package 'no_such_package'"),
                (('check', self.folder), 'is a folder')):
            result = run(*words, cwd=self.folder)
            self.assertEqual((result.returncode, result.stdout), (2, ''), words)
            self.assertIn(said, result.stderr, words)
            self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        self.assertEqual(os.listdir(self.folder), [])

    def test_help_and_version(self):
        overview = self.good('--help')
        for verb in ('check', 'solve', 'stability', 'envelope', 'simulate', 'report', 'import'):
            self.assertRegex(overview, r'\n  %s +\w' % verb)
            self.assertIn('--json', self.good(verb, '--help'))
        self.assertRegex(self.good('--version'), r'^cable_variation \d+\.\d+\.\d+\n$')

    def test_options_are_the_fields_of_the_services(self):
        shown = {'show', 'show_components', 'show_pieces', 'sample_shapes'}  # in RViz
        for verb, service in (('solve', 'SolveEquilibrium'), ('stability', 'AnalyzeStability'),
                              ('envelope', 'GenerateEnvelope'), ('simulate', 'SimulateVariation')):
            with open(os.path.join(SOURCES, 'srv', service + '.srv'), encoding='utf-8') as file:
                fields = set(re.findall(r'^\w+(?:\[\])? +(\w+)', file.read().split('---')[0], re.MULTILINE)) - shown
            options = set(re.findall(r'^  --(\w+)', self.good(verb, '--help'), re.MULTILINE))
            self.assertLessEqual(fields, options, verb)
            self.assertLessEqual(options - fields, {'set', 'output_directory', 'author', 'threads', 'memory_limit',
                                                    'json', 'help', 'first_sample', 'resume'})

    def test_solve_with_units_as_without(self):
        plain = self.answer('solve', HARNESS, '--variables', 'wh_start_rz', '--values', '0.05')
        for words in (('--set', 'wh_start_rz=50mrad'), ('--set=wh_start_rz=0.05',),
                      ('--variables=wh_start_rz', '--values=0.05')):
            other = self.answer('solve', HARNESS, *words)
            del other['solve_time']
            self.assertEqual(other, {name: value for name, value in plain.items() if name != 'solve_time'}, words)
        self.assertGreater(plain['smallest_eigenvalue'], 0)
        text = self.good('solve', HARNESS, '--set', 'wh_start_rz=0.05')
        self.assertIn('%.4g' % plain['smallest_eigenvalue'], text)
        self.assertIn('%.4g' % (1e3 * plain['shapes'][0]['smallest_bend_radius']), text)
        for measure in plain['measures']:
            self.assertIn(measure['name'], text)

    def test_files_are_where_they_were_asked_for(self):
        below = os.path.join(self.folder, 'a', 'b')
        answer = self.answer('solve', HARNESS, '--report', 'at_rest', '--output_directory', below)
        self.assertEqual(answer['report_file'], os.path.join(below, 'at_rest.html'))
        self.assertEqual(os.listdir(below), ['at_rest.html'])
        answer = self.answer('stability', HARNESS, '--skip_low_high', '--report', 's')
        self.assertEqual([answer['csv_file'], answer['report_file']],
                         [os.path.join(self.folder, 's.csv'), os.path.join(self.folder, 's.html')])
        answer = self.answer('simulate', HARNESS, '--samples', '200', '--name', 'run')
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if name.startswith('run')),
                         ['run.csv', 'run.html', 'run_contributions.csv', 'run_statistics.csv'])
        with open(answer['samples_file'], encoding='utf-8') as file:
            self.assertEqual(len(file.readlines()), 201)

    def test_what_cannot_be_written_is_1_with_the_answer(self):
        in_the_way = self.scene('in_the_way', '')
        result = run('solve', HARNESS, '--report', 'x', '--output_directory', in_the_way, '--json')
        answer = parsed(result.stdout)
        self.assertEqual((result.returncode, answer['status']['code'], answer['report_file']), (1, 6, ''))
        self.assertIn(in_the_way, result.stderr)
        self.assertTrue(answer['shapes'])
        if os.path.exists('/dev/full'):
            with open('/dev/full', 'w', encoding='utf-8') as full:
                result = subprocess.run([PROGRAM, 'check', HARNESS], stdout=full, stderr=subprocess.PIPE, text=True,
                                        timeout=PATIENCE, check=False, env=ENVIRONMENT)
            self.assertEqual(result.returncode, 1)
            self.assertIn('cannot be written', result.stderr)

    def test_import_writes_a_scene_that_solves(self):
        kbl = os.path.join(SOURCES, 'test', 'data', 'kbl', 'small.kbl')
        mapping = self.scene('map.yaml', 'parts:\n  F-100: {clip: sliding_rolling}\n')
        text = self.good('import', kbl, '--mapping', mapping, '-o', 'scene.yaml')
        self.assertIn('scene.yaml: 4 segments as 3 cables, 2 joints and 4 clips; 0 findings', text)
        self.assertIn('default: bundle.density', text)
        self.good('solve', 'scene.yaml')
        with open(os.path.join(self.folder, 'scene.yaml'), encoding='utf-8') as file:
            self.assertEqual(self.good('import', kbl, '--mapping', mapping), file.read())
        answer = self.answer('import', kbl, '--rest_shape', 'curve', '--output', 'curve.yaml')
        self.assertEqual((answer['cables'], answer['findings'], answer['output']), (3, [], 'curve.yaml'))
        self.assertIn('clip fixed', ' '.join(answer['defaults']))
        self.good('solve', 'curve.yaml')

    def test_import_tells_what_is_stale_and_what_is_broken(self):
        with open(os.path.join(SOURCES, 'test', 'data', 'kbl', 'small.kbl'), encoding='utf-8') as file:
            kbl = file.read()
        stale = self.scene('stale.kbl', kbl.replace('>200.000000<', '>230.000000<'))
        result = run('import', stale, '-o', 'scene.yaml', cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"^warning: .*stale.kbl:\d+: stale curve: Segment 'Segment_1': .* 200 mm long")
        broken = self.scene('broken.kbl', kbl.replace('<Start_node>Node_1<', '<Start_node>Node_77<'))
        result = run('import', broken, '-o', 'broken.yaml', cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"broken.kbl:\d+: Segment 'Segment_1', Start_node: .*'Node_77'")
        self.assertFalse(os.path.exists(os.path.join(self.folder, 'broken.yaml')))
        mapping = self.scene('map.yaml', 'part: {}\n')
        result = run('import', stale, '--mapping', mapping, cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ''))
        self.assertIn("did you mean 'parts'", result.stderr)

    def test_export_writes_the_shape_that_solve_has(self):
        words = (HARNESS, '--set', 'wh_start_rz=3deg')
        shape = self.answer('solve', *words)['shapes'][0]
        answer = self.answer('export', *words, '--cables', shape['cable'], '--formats', 'csv,vtk,dxf,stl', '--step', '5mm',
                             '--name', 'made')
        self.assertEqual([os.path.basename(path) for path in answer['files']],
                         ['made.csv', 'made.vtk', 'made.dxf', 'made.stl'])
        for path in answer['files']:
            self.assertGreater(os.path.getsize(path), 1000)
        with open(answer['files'][0], encoding='utf-8', newline='') as file:
            rows = list(csv.DictReader(file))
        end = shape['section'][-1]['position']
        for axis in 'xyz':
            self.assertAlmostEqual(float(rows[-1]['%s [m]' % axis]), end[axis], delta=1e-15)
        self.assertEqual({row['cable'] for row in rows}, {shape['cable']})
        for verb in ('solve', 'export'):
            result = run(verb, HARNESS, '--time', '1', cwd=self.folder)
            self.assertEqual(result.returncode, 2)
            self.assertIn('--time: is given without --motion', result.stderr)
        self.assertEqual(run('export', HARNESS, '--formats', 'step', cwd=self.folder).returncode, 2)
        self.assertEqual(run('export', HARNESS, '--cables', 'nobody', cwd=self.folder).returncode, 2)
        self.assertEqual(run('export', HARNESS, '--step', '0mm', cwd=self.folder).returncode, 2)

    def test_deviations_from_routes_go_back_beside_their_ids(self):
        kbl = os.path.join(SOURCES, 'test', 'data', 'kbl', 'small.kbl')
        self.good('import', kbl, '-o', 'routed.yaml')
        text = self.good('solve', 'routed.yaml')
        self.assertIn('How far cables are from their planned routes', text)
        measures = {measure['name']: measure for measure in self.answer('solve', 'routed.yaml')['measures']}
        answer = self.answer('export', 'routed.yaml', '--formats', 'routes', '--name', 'small')
        self.assertEqual([os.path.basename(path) for path in answer['files']], ['small_routes.csv'])
        with open(answer['files'][0], encoding='utf-8', newline='') as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row['segment'] for row in rows}, {measure['segment'] for measure in measures.values()})
        for row in rows:
            measure = measures[row['measure']]
            self.assertAlmostEqual(float(row['deviation [m]']), measure['value'], delta=1e-12)
            apart = math.dist([float(row['%s [m]' % axis]) for axis in 'xyz'],
                              [float(row['route %s [m]' % axis]) for axis in 'xyz'])
            self.assertAlmostEqual(apart, measure['value'], delta=1e-9)
        self.good('solve', 'routed.yaml', '--report', 'routed')
        with open(os.path.join(self.folder, 'routed.html'), encoding='utf-8') as file:
            self.assertIn('planned routes', file.read())
        result = run('export', HARNESS, '--formats', 'routes', cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn('no measure of the type route_deviation', result.stderr)

    def test_identify_finds_what_a_shape_was_made_with(self):
        loop = self.scene('loop.yaml', HANGING)
        self.answer('export', loop, '--set', 'EI=1.5e-4', 'a_rz=4deg', '--name', 'measured')
        answer = self.answer('identify', loop, '--variables', 'EI,a_rz', '--points', 'measured.csv', '--compare',
                             'measured.csv', '--name', 'found')
        values = {value['variable']: value for value in answer['values']}
        self.assertAlmostEqual(values['EI']['value'], 1.5e-4, delta=1.5e-8)
        self.assertAlmostEqual(values['a_rz']['value'], math.radians(4), delta=1e-4)
        self.assertTrue(values['EI']['determined'] and values['a_rz']['determined'])
        self.assertLess(answer['compared'][0]['rms'], 2e-5)
        # the scene that it writes hangs as the wire did
        before, after = (self.answer('solve', *words)['shapes'][0]['centreline'] for words in (
            (loop, '--set', 'EI=1.5e-4', 'a_rz=4deg'), (answer['scene_file'],)))
        for one, other in zip(before, after):
            self.assertLess(math.dist(one.values(), other.values()), 1e-4)
        # what is read is not written over
        for name in ('measured', 'loop'):
            result = run('identify', loop, '--variables', 'EI', '--points', 'measured.csv', '--name', name, cwd=self.folder)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn('would be written over', result.stderr)
        with open(os.path.join(self.folder, 'measured.csv'), encoding='utf-8') as file:
            self.assertTrue(file.readline().startswith('cable,arc length'))
        with open(loop, encoding='utf-8') as file:
            self.assertEqual(file.read(), HANGING)
        for words in (('--points', 'measured.csv'), ('--variables', 'EI'),
                      ('--variables', 'EI', '--points', 'nowhere.csv'),
                      ('--variables', 'nobody', '--points', 'measured.csv'),
                      ('--variables', 'EI,EI', '--points', 'measured.csv')):
            result = run('identify', loop, *words, cwd=self.folder)
            self.assertEqual(result.returncode, 2, (words, result.stderr))

    def test_no_equilibrium_is_1(self):
        scene = self.scene('apart.yaml', OUT_OF_REACH)
        for verb in ('check', 'solve', 'stability'):
            result = run(verb, scene, '--json')
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertEqual(parsed(result.stdout)['status']['code'], 3)
            self.assertEqual(result.stderr.count('\n'), 1, result.stderr)

    def test_any_number_of_threads_gives_the_same_bits(self):
        timeless = []
        for threads in ('1', '2'):
            answer = self.answer('simulate', HARNESS, '--samples', '1500', '--seed', '7', '--threads', threads)
            for name in ('simulation_time', 'samples_per_second', 'report_time'):
                del answer[name]
            timeless.append(answer)
        self.assertEqual(*timeless)

    def test_envelope_and_report(self):
        words = ('--variables', 'wh_start_ry', '--verification_shapes', '200', '--name', 'e')
        answer = self.answer('envelope', HARNESS, *words)
        self.assertEqual(answer['variables'], ['wh_start_ry'])
        self.assertGreater(answer['volume'], 0)
        for kind in ('mesh', 'urdf', 'region', 'report'):
            self.assertTrue(os.path.exists(answer[kind + '_file']), kind)
        answer = self.answer('report', HARNESS, '--samples', '500', '--chapters', 'simulation', '--report', 'page')
        with open(answer['report_file'], encoding='utf-8') as file:
            page = file.read()
        for chapter in ('The design at rest', 'Stability analysis', 'Variation simulation'):
            self.assertIn(chapter, page)
        self.assertIn(answer['verdict'], ('pass', 'marginal', 'fail', 'unknown', 'no limits'))

    def test_progress_on_a_terminal(self):
        terminal, end = pty.openpty()
        process = subprocess.Popen([PROGRAM, 'simulate', HARNESS, '--samples', '20000'], stdout=subprocess.PIPE,
                                   stderr=end, env=ENVIRONMENT)
        os.close(end)
        shown = b''
        while True:
            try:
                part = os.read(terminal, 4096)
            except OSError:  # nobody writes there any more
                break
            if not part:
                break
            shown += part
        process.communicate(timeout=PATIENCE)
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(shown.decode(), r'\r  samples +\[#*\.*\] +\d+ %  \d+ of 20000')
        self.assertTrue(shown.endswith(b'\r'))

    def interrupted(self, words, begun):
        """What a run leaves that is interrupted once begun() is true: exit code, both outputs, seconds to the end."""
        process = subprocess.Popen([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   cwd=self.folder, env=ENVIRONMENT)
        end = time.time() + PATIENCE
        while not begun():
            self.assertIsNone(process.poll(), 'it has ended')
            self.assertLess(time.time(), end)
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=PATIENCE)
        return process.returncode, out, err

    def test_ctrl_c_leaves_no_half_files(self):
        start = time.time()
        words = ('envelope', HARNESS, '--name', 'half', '--verification_shapes', '10000000')
        code, out, err = self.interrupted(words, lambda: time.time() > start + 2)
        self.assertEqual((code, out), (1, ''))
        self.assertEqual(err, 'cable_variation envelope: cancelled\n')
        self.assertEqual(os.listdir(self.folder), [])

    def test_ctrl_c_keeps_the_samples_done(self):
        partial = os.path.join(self.folder, 'long.csv.partial')
        words = ('simulate', HARNESS, '--samples', '10000000', '--name', 'long', '--json')
        code, out, err = self.interrupted(words,
                                          lambda: os.path.exists(partial) and os.path.getsize(partial) > 100000)
        answer = parsed(out)
        self.assertEqual((code, answer['status']['code']), (1, 5))
        self.assertRegex(err, r'^cable_variation simulate: cancelled after \d+ of 10000000 samples; '
                              r'--resume goes on from there\n$')
        self.assertGreater(answer['samples'], 0)
        self.assertEqual(answer['samples_file'], partial)
        self.assertFalse(os.path.exists(os.path.join(self.folder, 'long.csv')))
        with open(partial, encoding='utf-8') as file:
            lines = file.readlines()
        self.assertEqual(len(lines), 1 + answer['samples'])
        self.assertTrue(lines[-1].endswith('\n'))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
