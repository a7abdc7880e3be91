# No program is linked to what modules are for.
foreach(program mdbd-index mdbd-query mdbd-decompose mdbd-evaluate mdbd-perturb mdbd-db)
  mdbd_cli_test(NAME modules/not_linked_to_${program}
    COMMAND sh -c "ldd '$<TARGET_FILE:${program}>' >libraries && grep -q libstdc libraries && \
      ! grep -E '/lib(TK|vtk|assimp|pcl_io|pcl_features)' libraries")
endforeach()

set(index "'$<TARGET_FILE:mdbd-index>' models --balls 5")
mdbd_cli_test(NAME modules/files_of_all
  SETUP "'$<TARGET_FILE:write_shape_files>' models"
  COMMAND sh -c "${index}" REGEXP "indexed +4\n")

# A module that cannot be loaded costs the models that need it, until it can. With sanitizers
# LD_LIBRARY_PATH comes too late (cmake/settings.cmake).
if(MDBD_SANITIZE)
  return()
endif()
mdbd_cli_test(NAME modules/damaged
  SETUP "'$<TARGET_FILE:write_shape_files>' models && mkdir damaged && : >damaged/mdbd_cad.so"
  COMMAND sh -c "LD_LIBRARY_PATH=damaged ${index} || test $? = 3 && ${index}"
  REGEXP "indexed +3\n" "box\\.step: needs the module mdbd_cad, which cannot be loaded: [^\n]*mdbd_cad\\.so"
         "indexed +1\n")
