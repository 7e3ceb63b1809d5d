# Another view of the scene.
set(other_view ${PROJECT_BINARY_DIR}/doc/example_scene_turned.pcd)
add_test(NAME example.make_turned_scene
  COMMAND pcl_shape_scene ${other_view} -seed 1 -width 320 -height 240 -turn 20)
set_tests_properties(example.make_turned_scene PROPERTIES FIXTURES_SETUP example_scene)
set(TUTORIAL_ARGUMENTS ${TUTORIAL_SCENE} ${other_view} both.pcd)
