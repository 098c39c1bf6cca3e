#!/usr/bin/env python3
"""Parts of a simulation made apart, by the program cable_variation: shards_test.py PROGRAM SOURCES [MPIEXEC]"""
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SOURCES = (os.path.abspath(word) for word in sys.argv[1:3])
MPIEXEC = sys.argv[3] if len(sys.argv) > 3 else ''
HARNESS = os.path.join(SOURCES, 'config', 'harness.yaml')
FILES = ('.csv', '_statistics.csv', '_contributions.csv')
PATIENCE = 170  # [s]; the machine may be busy
SAMPLES = 1500
MANY = 60000  # takes long enough to be killed in the middle

# Nothing but a cable: a report of it is quickly written.
LOOP = """
materials:
  bundle: {young_modulus: 1.0e8, poisson_ratio: 0.25, density: 2000}
cables:
  - {name: main, length: 300 mm, section: {type: solid, radius: 4 mm, material: bundle}}
clips:
  - {name: start, type: fixed, cable: main, at: start, pose: {position: [0, 0, 0]}}
  - {name: end, type: fixed, cable: main, at: end, pose: {position: [0.2, 0, 0.1]}}
design_variables:
  - {name: length, cable: main, property: length, tolerance: 3 mm, distribution: {type: uniform}}
  - {name: start_ry, clip: start, rotate: y, tolerance: 5 deg, distribution: {type: normal, sigma: 3}}
  - {name: end_z, clip: end, translate: z, tolerance: 2 mm, distribution: {type: normal, sigma: 3}}
measures:
  - {name: bend, type: bend_radius, cable: main, lower: 40 mm}
"""

ENVIRONMENT = {'PATH': '/usr/bin:/bin', 'OMPI_MCA_rmaps_base_oversubscribe': '1', 'HOME': os.environ.get('HOME', '/'),
               'OMPI_ALLOW_RUN_AS_ROOT': '1', 'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1'}
ENVIRONMENT.update({name: value for name, value in os.environ.items()
                    if 'SAN_OPTIONS' in name or name == 'LD_LIBRARY_PATH'})

# What tells of how it was done, not of what was found.
DOINGS = ('simulation_time', 'samples_per_second', 'report_time', 'samples_file', 'statistics_file', 'report_file',
          'contributions_file', 'blocks_file', 'resumed_samples', 'shards', 'blocks_solved_again')


def content(path):
    with open(path, 'rb') as file:
        return file.read()


def figures(answer):
    return {name: value for name, value in answer.items() if name not in DOINGS}


class ShardsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.scene = os.path.join(cls.folder, 'loop.yaml')
        with open(cls.scene, 'w', encoding='utf-8') as file:
            file.write(LOOP)
        cls.whole = cls.answer(cls.simulation('whole'))

    @classmethod
    def simulation(cls, name, *more, samples=SAMPLES):
        return ('simulate', cls.scene, '--samples', str(samples), '--name', name, *more)

    @classmethod
    def run_program(cls, words, ranks=0, **options):
        launcher = [MPIEXEC, '-n', str(ranks)] if ranks else []
        return subprocess.run([*launcher, PROGRAM, *words], capture_output=True, text=True, timeout=PATIENCE,
                              check=False, env=ENVIRONMENT, cwd=cls.folder, **options)

    @classmethod
    def answer(cls, words, ranks=0):
        result = cls.run_program((*words, '--json'), ranks)
        if result.returncode != 0:
            raise AssertionError('%s: %s' % (words, result.stderr))
        return json.loads(result.stdout)

    def path(self, name):
        return os.path.join(self.folder, name)

    def same_as_whole(self, answer, name):
        self.assertEqual(figures(answer), figures(self.whole))
        for ending in FILES:
            self.assertEqual(content(self.path(name + ending)), content(self.path('whole' + ending)), ending)

    def shard(self, name, first, end, *more):
        return self.answer(self.simulation(name, '--first-sample', str(first), *more, samples=end - first))

    def refused(self, words, *texts, code=2, ranks=0):
        result = self.run_program(words, ranks)
        for text in texts:
            self.assertIn(text, result.stderr, words)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def killed(self, words, file, size, ranks=0):
        """Ends a run the hard way once a file has that size."""
        launcher = [MPIEXEC, '-n', str(ranks)] if ranks else []
        with subprocess.Popen([*launcher, PROGRAM, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True, env=ENVIRONMENT, cwd=self.folder) as process:
            end = time.time() + PATIENCE
            while not os.path.exists(self.path(file)) or os.path.getsize(self.path(file)) < size:
                self.assertIsNone(process.poll(), 'it has ended')
                self.assertLess(time.time(), end)
                time.sleep(0.002)
            self.kill(process, ranks)
            _, err = process.communicate(timeout=PATIENCE)
        self.assertNotEqual(process.returncode, 0)
        return err

    def kill(self, process, ranks):
        if not ranks:
            process.kill()
            return
        children = subprocess.run(['ps', '-o', 'pid=', '--ppid', str(process.pid)], capture_output=True, text=True,
                                  check=True).stdout.split()
        os.kill(int(children[-1]), signal.SIGKILL)  # the last rank

    def test_shards_of_any_size_are_the_whole(self):
        numbers = random.Random(7)
        for trial in range(2):
            ends = sorted(numbers.sample(range(1, SAMPLES), 3)) + [SAMPLES]
            names = []
            for number, (first, end) in enumerate(zip([0] + ends, ends)):
                names.append('part_%d_%d' % (trial, number))
                answer = self.shard(names[-1], first, end, '--threads', str(1 + number % 2))
                self.assertEqual(answer['samples'], end - first)
            numbers.shuffle(names)
            merged = self.answer(('merge', *[name + '.blocks' for name in names], '--name', 'merged'))
            self.same_as_whole(merged, 'merged')
            self.assertEqual(merged['shards'], 4)
            self.assertEqual(merged['blocks_solved_again'], len({end // 128 for end in ends[:-1] if end % 128}))

    def test_shards_that_do_not_fit_are_told(self):
        self.shard('a', 0, 256)
        self.shard('b', 256, 384)
        self.shard('c', 512, 640)
        self.shard('late', 300, 512)
        self.shard('seed', 384, 512, '--seed', '3')
        self.refused(('merge', 'a.blocks', 'c.blocks', 'b.blocks'), 'samples 384 to 511 are in none')
        self.refused(('merge', 'b.blocks'), 'samples 0 to 255 are in none')
        self.refused(('merge', 'a.blocks', 'late.blocks', 'b.blocks'), 'samples 300 to 383 are in both',
                     "'b.blocks'", "'late.blocks'")
        self.refused(('merge', 'a.blocks', 'a.blocks'), 'are in both')
        self.refused(('merge', 'a.blocks', 'b.blocks', 'seed.blocks'), "seed: 1 in 'a.blocks', 3 in 'seed.blocks'")
        self.refused(('merge', 'a.blocks', HARNESS), HARNESS, 'does not begin as a file of blocks')
        self.refused(('merge', 'a.blocks', 'none.blocks'), 'none.blocks', 'cannot be read', code=1)
        self.refused(('merge',), 'SHARDS are missing')
        self.refused(('simulate', HARNESS, '--first-sample', '5', '--samples', '5'), 'without --name')
        self.refused(('simulate', HARNESS, '--resume'), 'without --name')
        self.refused(('simulate', HARNESS, '--first-sample', '5', '--name', 'x'), 'without --samples')
        self.refused(self.simulation('x', '--first-sample', '5', '--sampler', 'latin_hypercube'), 'latin_hypercube')
        self.refused(self.simulation('x', '--first-sample', '5', '--sigma_error', '2%'), 'sigma_error')

    def test_a_shard_that_is_cut_off_is_told_and_completed(self):
        self.shard('first', 0, 700)
        self.shard('second', 700, SAMPLES)
        path = self.path('second.blocks')
        whole = content(path)
        numbers = random.Random(3)
        for size in [len(whole) - 1] + [numbers.randrange(len(whole) // 20, len(whole)) for _ in range(3)]:
            with open(path, 'wb') as file:
                file.write(whole[:size])
            self.refused(('merge', 'first.blocks', 'second.blocks'), "'second.blocks' is not complete", '--resume')
            answer = self.shard('second', 700, SAMPLES, '--resume')
            self.assertLess(answer['resumed_samples'], SAMPLES - 700)
            self.assertEqual(content(path), whole)
        with open(path, 'wb') as file:
            file.write(whole[:100])
        self.refused(('merge', 'first.blocks', 'second.blocks'), 'damaged')

    def same_as_found(self, answer, name):
        found = self.answer(self.simulation('found', samples=MANY))
        self.assertEqual(figures(answer), figures(found))
        for ending in FILES:
            self.assertEqual(content(self.path(name + ending)), content(self.path('found' + ending)), ending)

    def test_a_killed_run_goes_on(self):
        self.killed(self.simulation('killed', samples=MANY), 'killed.blocks', 100000)
        self.assertFalse(os.path.exists(self.path('killed.csv')))
        self.refused(self.simulation('killed', '--resume', '--seed', '9', samples=MANY), 'seed: 1 in the file, 9 now')
        self.refused(self.simulation('killed', '--resume', samples=10), 'samples 0 to %d in the file' % (MANY - 1))
        answer = self.answer(self.simulation('killed', '--resume', samples=MANY))
        self.assertGreater(answer['resumed_samples'], 0)
        self.assertLess(answer['resumed_samples'], MANY)
        self.same_as_found(answer, 'killed')
        self.assertFalse(os.path.exists(self.path('killed.blocks')))
        answer = self.answer(self.simulation('new', '--resume'))
        self.assertEqual(answer['resumed_samples'], 0)
        self.same_as_whole(answer, 'new')

    def test_a_run_that_was_killed_as_it_began_begins_anew(self):
        self.shard('early', 0, SAMPLES)
        with open(self.path('early.blocks'), 'rb') as file:
            begun = file.read(200)
        for size in (0, 1, 10, 30, 100):
            with open(self.path('early.blocks'), 'wb') as file:
                file.write(begun[:size])
            answer = self.answer(self.simulation('early', '--resume'))
            self.assertEqual(answer['resumed_samples'], 0)
            self.same_as_whole(answer, 'early')
        with open(self.path('early.blocks'), 'w', encoding='utf-8') as file:
            file.write('notes\n')
        self.refused(self.simulation('early', '--resume'), 'does not begin as a file of blocks')

    def test_numbers_of_a_block_are_checked(self):
        self.shard('first', 0, 256)
        self.shard('numbers', 256, SAMPLES)
        with open(self.path('numbers.blocks'), 'r+b') as file:
            file.seek(len('cable_variation blocks 1\n') + 8)
            file.write(b'\x07')
        self.refused(('merge', 'first.blocks', 'numbers.blocks', '--name', 'all'), 'header is damaged')

    def test_a_full_disk_is_told(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))
        result = self.run_program(self.simulation('full', '--first-sample', '0'), preexec_fn=small_files)
        self.assertEqual(result.returncode, 1)
        self.assertIn('full.blocks', result.stderr)
        self.assertIn('cannot be written', result.stderr)
        answer = self.shard('full', 0, SAMPLES, '--resume')
        self.assertGreater(answer['resumed_samples'], 0)
        self.same_as_whole(self.answer(('merge', 'full.blocks', '--name', 'not_full')), 'not_full')
        free = shutil.disk_usage(self.folder).free
        samples = 1000000000
        if free < 40 * samples:
            self.refused(self.simulation('x', samples=samples), 'GB free', code=1)

    @unittest.skipUnless(MPIEXEC, 'built without MPI')
    def test_ranks_give_the_same_bits(self):
        for ranks, threads in ((2, '1'), (3, '2')):
            name = 'ranks_%d' % ranks
            self.same_as_whole(self.answer(self.simulation(name, '--threads', threads), ranks), name)

    @unittest.skipUnless(MPIEXEC, 'built without MPI')
    def test_faults_are_told_once_by_all_ranks(self):
        result = self.refused(self.simulation('x', '--sampler', 'halton'), "'halton'", ranks=2)
        self.assertEqual(result.stderr.count('halton'), 1, result.stderr)
        script = self.path('unequal')
        with open(script, 'w', encoding='utf-8') as file:
            file.write('#!/bin/sh\nexec "$@" --seed "$((OMPI_COMM_WORLD_RANK + 1))"\n')
        os.chmod(script, 0o755)
        result = subprocess.run([MPIEXEC, '-n', '2', script, PROGRAM, *self.simulation('x')], capture_output=True,
                                text=True, timeout=PATIENCE, check=False, env=ENVIRONMENT, cwd=self.folder)
        self.assertIn('seed: 1 on rank 0, 2 there', result.stderr)
        self.assertFalse(os.path.exists(self.path('x.blocks')))

    @unittest.skipUnless(MPIEXEC, 'built without MPI')
    def test_a_run_whose_rank_is_killed_goes_on(self):
        err = self.killed(self.simulation('lost', '--threads', '1', samples=MANY), 'lost.blocks', 100000, 2)
        self.assertIn('rank', err)
        answer = self.answer(self.simulation('lost', '--resume', samples=MANY))
        self.assertGreater(answer['resumed_samples'], 0)
        self.same_as_found(answer, 'lost')


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
