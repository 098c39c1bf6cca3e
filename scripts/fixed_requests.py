"""The requests that compare_answers asks of every scene: the same ones of the same scene, and small ones."""

SOLVER, MOVING, STATIC = '/cable_solver', '/moving_geometry_node', '/static_geometry_node'
SMALL = 3  # variables of what takes long


def service(kind, label='', service_name=None, node=SOLVER, **fields):
    """A request of a service, by default the one named as its kind, in small letters."""
    snake = ''.join('_' + letter.lower() if letter.isupper() else letter for letter in kind).lstrip('_')
    return {'how': 'service', 'name': node + '/' + (service_name or snake), 'kind': kind, 'label': label,
            'fields': fields}


def action(kind, label='', **fields):
    request = service(kind, label, **fields)
    return {**request, 'how': 'action', 'name': request['name'] + '_action'}


def topics(label, node, *names):
    """What the latched topics of a node tell now."""
    return [{'how': 'topic', 'name': node + '/' + name, 'label': label} for name in names]


def equilibria(variables, motion, duration):
    names = [each.name for each in variables]
    solve = 'SolveEquilibrium'
    yield service(solve, 'nominal')
    for each in variables:
        yield service(solve, each.name + ' low', variables=[each.name], values=[each.lower])
        yield service(solve, each.name + ' high', variables=[each.name], values=[each.upper])
    half = {'variables': names, 'values': [0.5 * each.upper for each in variables]}
    yield service(solve, 'all half way up', **half)
    yield service(solve, 'all half way up, followed', follow=True, **half)
    yield service(solve, 'no such variable', variables=['nobody'], values=[0.0])
    yield service(solve, 'a value missing', variables=names[:2], values=[0.0])
    yield service(solve, 'not a number', variables=names[:1], values=[float('nan')])
    yield service(solve, 'no such motion', motion='nobody')
    if motion:
        for share in (0.0, 0.3, 0.77, 1.1):
            yield service(solve, 'at %g of %s' % (share, motion), motion=motion, time=share * duration)


def analyses(variables, measures):
    names = [each.name for each in variables]
    analyse = 'AnalyzeStability'
    yield service(analyse, 'all, with a report', report='stability')
    yield from topics('of the largest effect', SOLVER, 'variation', 'legend')
    yield service(analyse, 'another design', nominal_variables=names[:SMALL],
                  nominal_values=[0.3 * each.upper for each in variables[:SMALL]], skip_low_high=True)
    yield service(analyse, 'one by one, shown', variables=names[-1:], measures=measures[:1], show=names[-1])
    yield from topics('of one variable', SOLVER, 'variation', 'legend')
    yield service(analyse, 'components', show_components=True, skip_low_high=True)
    yield from topics('of components', SOLVER, 'variation', 'legend')
    yield service(analyse, 'no such measure', measures=['nobody'])


def envelopes(names, cables, motion, duration):
    envelope, some = 'GenerateEnvelope', names[:SMALL]
    quick = {'verification_shapes': 100, 'mesh_excess': 5e-3, 'seed': 7}
    yield service(envelope, 'worst case', variables=some, tightness_shapes=50, tightness_voxel=4e-3,
                  name='worst_case', show_pieces=True, **quick)
    yield from topics('with an envelope', SOLVER, 'envelope', 'envelope_mesh', 'interference')
    yield service(envelope, '90 % of production', variables=some, probability=0.9, mesh_excess=5e-3, seed=7)
    yield service(envelope, 'one cable, not conservative', variables=names[-1:], cables=cables[:1],
                  non_conservative=True, skip_near_clips=-1.0, **quick)
    yield service(envelope, 'no such cable', variables=some, cables=['nobody'])
    yield service(envelope, 'a probability of 2', variables=some, probability=2.0)
    yield action(envelope, 'worst case', variables=names[:1], **quick)
    if motion:
        some_of_it = {'motions': [motion], 'from_time': 0.2 * duration, 'to_time': 0.25 * duration}
        yield service(envelope, 'motion only', motion_only=True, **some_of_it, **quick)
        yield service(envelope, 'over a motion', variables=names[:1], **some_of_it, **quick)


def regions(components):
    check = 'CheckForbiddenRegion'
    yield service(check, 'all components', region='worst_case')
    yield service(check, 'one component', region='worst_case', components=components[:1])
    yield service(check, 'a mesh', region='worst_case', mesh='package://cable_variation/meshes/tie_stay.stl',
                  pose={'position': {'x': 0.3, 'y': 0.2, 'z': 0.4}})
    yield service(check, 'no such region', region='nobody')


def simulations(names, measures, motion, duration):
    simulate = 'SimulateVariation'
    yield service(simulate, 'all, with files', samples=300, seed=7, variables=['*'], sample_shapes=5, name='production')
    yield from topics('of a simulation', SOLVER, 'variation', 'legend')
    for sampler in ('latin_hypercube', 'sobol'):
        yield service(simulate, sampler, samples=200, seed=7, variables=['*'], sampler=sampler, show='range',
                      sections=9)
    yield service(simulate, 'to a sigma', samples=1000, sigma_error=0.2, variables=names[:SMALL], measures=measures[:2],
                  confidence=0.9)
    yield service(simulate, 'no such sampler', sampler='nobody', variables=['*'])
    yield action(simulate, 'all', samples=100, seed=3, variables=['*'])
    if motion:
        yield service(simulate, 'over a motion', samples=20, seed=7, variables=names[:SMALL], motions=[motion],
                      from_time=0.2 * duration, to_time=0.25 * duration)


def designs(variables, cables, clips):
    design = 'SetDesign'
    yield service(design, 'variables', variables=[each.name for each in variables[:SMALL]],
                  values=[0.4 * each.upper for each in variables[:SMALL]])
    yield from topics('of another design', SOLVER, 'cables', 'shapes', 'component_deviations', 'interference')
    yield service('SolveEquilibrium', 'of that design', variables=[variables[0].name], values=[variables[0].upper])
    yield service(design, 'a length and a clip', cables=[{'cable': cables[0].name, 'length': 1.01 * cables[0].length}],
                  clips=[{'clip': clips[-1], 'translation': {'y': 2e-3}, 'rotation': {'z': 0.02}}])
    yield service('GetScene', 'of that design')
    yield service('AnalyzeStability', 'of that design')
    yield service(design, 'too short', cables=[{'cable': cables[0].name, 'length': 0.3 * cables[0].length}])
    yield service(design, 'no such clip', clips=[{'clip': 'nobody'}])
    yield service('Trigger', service_name='reset_design')
    yield from topics('of the design again', SOLVER, 'shapes')


def attachments(clips):
    attach = 'SetAttachment'
    yield service(attach, 'opened', clip=clips[-1], attached=False)
    yield from topics('of an open clip', SOLVER, 'cables', 'shapes')
    yield service(attach, 'closed again', clip=clips[-1], attached=True, reach=1.0)
    yield service(attach, 'no such clip', clip='nobody')
    yield service('Trigger', 'after clips', service_name='reset_design')


def paths(clips, motion, duration):
    check = 'CheckPath'
    yield service(check, 'no such clip', clip='nobody')
    yield service(check, 'a pose', clip=clips[-1], path={'poses': [{'pose': {'orientation': {'w': 1.0}}}]})
    if motion:
        yield service(check, 'a motion', motions=[motion], from_time=0.2 * duration, to_time=0.25 * duration,
                      report='path')
        yield from topics('of a path', SOLVER, 'path_check')


def saved_scenes():
    save = 'SaveScene'
    yield service(save, 'as it is', name='saved')
    yield service(save, 'again', name='saved')
    yield service(save, 'no name for a file', name='../up')


def motions(motion, duration):
    yield service('SetBool', 'halt', service_name='play', node=MOVING, data=False)
    for share in (0.3, 1.1, float('nan')):
        yield service('Seek', 'to %g of the end' % share, node=MOVING, time=share * duration)
    if motion:
        yield {'how': 'topic', 'name': '/tf', 'label': 'halted'}


def fixed_requests(scene, path):
    """All requests of a scene that ~get_scene answered, loaded from `path`, as dictionaries: how (service, action or
    topic), name, kind and label; fields by name."""
    variables = scene.design_variables
    names = [each.name for each in variables]
    measures = [each.name for each in scene.measures]
    motion = scene.motions[0].name if scene.motions else ''
    duration = scene.motions[0].duration if scene.motions else 1.0
    yield service('GetScene')
    yield from topics('', STATIC, 'components')
    if motion:
        yield from topics('', MOVING, 'components')
    yield from topics('', SOLVER, 'cables', 'shapes', 'interference')
    yield from motions(motion, duration)
    yield from equilibria(variables, motion, duration)
    yield from analyses(variables, measures)
    yield from envelopes(names, [each.name for each in scene.cables], motion, duration)
    yield from regions([each.name for each in scene.components])
    yield from simulations(names, measures, motion, duration)
    yield from designs(variables, scene.cables, [each.name for each in scene.clips])
    clips = [each.name for each in scene.clips]
    yield from attachments(clips)
    yield from paths(clips, motion, duration)
    yield from saved_scenes()
    yield service('LoadScene', 'no such file', scene='package://cable_variation/config/nobody.yaml')
    yield service('LoadScene', 'again', scene=path)
    yield service('SolveEquilibrium', 'loaded again')
