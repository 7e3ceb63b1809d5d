set(street ${PROJECT_BINARY_DIR}/doc/example_street.pcd)
add_test(NAME example.make_street COMMAND pcl_shape_scene ${street} -sensor lidar -beams 16 -seed 1)
set_tests_properties(example.make_street PROPERTIES FIXTURES_SETUP example_scene)
set(TUTORIAL_ARGUMENTS ${street})
